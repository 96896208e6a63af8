// Everything that JavaScript may set and ask for, by name: one table, of which the page makes its controls, and a link that
// holds them all.
#include "web/module/web.h"

#include "base/text.h"
#include "scene/limits.h"

#include <stddef.h>
#include <stdio.h>

typedef enum { AS_DOUBLE, AS_FLOAT, AS_INT, AS_LONG, AS_U64, AS_SIZE, AS_BOOL } Storage;
typedef struct {
    const char *name;
    size_t offset; // in Page
    Storage storage;
    double low, high;
} Parameter;

#define IN(member) offsetof(Page, member)
static const Parameter PARAMETERS[] = {
    {"photons", IN(asked.photons), AS_LONG, 1, MOST_PHOTONS},
    {"depth", IN(asked.depth), AS_INT, 1, MOST_DEPTH},
    {"seed", IN(asked.seed), AS_U64, 0, 1e15},
    {"paths", IN(asked.recorded), AS_LONG, 0, 1e6},
    {"samples", IN(asked.samples), AS_LONG, 0, 1e6},
    {"spectral", IN(asked.spectral), AS_BOOL, 0, 1},
    {"k", IN(k), AS_INT, 1, MOST_K},
    {"radius", IN(radius), AS_FLOAT, 0, SCENE_LARGEST_NUMBER},
    {"integrator", IN(asked.integrator), AS_INT, 0, INTEGRATOR_PATH - 1},
    {"radii", IN(asked.radii), AS_INT, 0, RADII_RULES - 1},
    {"passes", IN(asked.passes), AS_INT, 0, 1e6},
    {"width", IN(asked.width), AS_INT, 0, IMAGE_MAX_SIDE},
    {"height", IN(asked.height), AS_INT, 0, IMAGE_MAX_SIDE},
    {"rendered", IN(show_rendered), AS_BOOL, 0, 1},
    {"view", IN(view.kind), AS_INT, 0, VIEW_COUNT - 1},
    {"colour", IN(view.colour), AS_INT, 0, COLOUR_COUNT - 1},
    {"wireframe", IN(view.wireframe), AS_BOOL, 0, 1},
    {"flight", IN(view.flight), AS_DOUBLE, -1, SCENE_LARGEST_NUMBER},
    {"most_points", IN(view.most_points), AS_SIZE, 0, MOST_PHOTONS},
    {"target_x", IN(view.orbit.target.x), AS_FLOAT, -SCENE_LARGEST_NUMBER, SCENE_LARGEST_NUMBER},
    {"target_y", IN(view.orbit.target.y), AS_FLOAT, -SCENE_LARGEST_NUMBER, SCENE_LARGEST_NUMBER},
    {"target_z", IN(view.orbit.target.z), AS_FLOAT, -SCENE_LARGEST_NUMBER, SCENE_LARGEST_NUMBER},
    {"distance", IN(view.orbit.distance), AS_FLOAT, SCENE_SMALLEST_LENGTH, SCENE_LARGEST_NUMBER},
    {"yaw", IN(view.orbit.yaw), AS_FLOAT, -SCENE_LARGEST_NUMBER, SCENE_LARGEST_NUMBER},
    {"pitch", IN(view.orbit.pitch), AS_FLOAT, -PI / 2, PI / 2},
    {"vertical_fov", IN(view.orbit.vertical_fov), AS_FLOAT, 1, 170},
    {"zoom", IN(view.framing.zoom), AS_FLOAT, LEAST_ZOOM, MOST_ZOOM},
    {"right", IN(view.framing.right), AS_FLOAT, -1e6, 1e6},
    {"up", IN(view.framing.up), AS_FLOAT, -1e6, 1e6},
};
enum { PARAMETER_COUNT = sizeof PARAMETERS / sizeof *PARAMETERS };

// Number i: those of the table, then the views' settings, which are called view.flag. False past the last.
static bool parameter_at(int i, Parameter *found, const ViewSetting **setting, char name[64])
{
    *setting = NULL;
    if (i < PARAMETER_COUNT) {
        *found = PARAMETERS[i];
        snprintf(name, 64, "%s", found->name);
        return true;
    }
    for (int view = 0, at = PARAMETER_COUNT; view < VIEW_COUNT; view++)
        for (int j = 0; j < MOST_SETTINGS && view_types[view]->settings[j].flag; j++)
            if (at++ == i) {
                const ViewSetting *s = *setting = &view_types[view]->settings[j];
                double high = s->kind == SETTING_SWITCH ? 1 : s->high;
                snprintf(name, 64, "%s.%s", view_names[view], s->flag);
                *found = (Parameter){name, IN(view.settings[view][j]), AS_DOUBLE, fmin(s->start, s->low), high};
                return true;
            }
    return false;
}

static bool find(const char *name, Parameter *found)
{
    const ViewSetting *setting;
    static char called[64];
    for (int i = 0; parameter_at(i, found, &setting, called); i++)
        if (strcmp(called, name) == 0)
            return true;
    return false;
}

double EXPORT(web_get)(const char *name) // NaN: there is none of this name
{
    Parameter p;
    if (!find(name, &p))
        return (double)NAN;
    const char *at = (const char *)&page + p.offset;
    switch (p.storage) {
    case AS_DOUBLE:
        return *(const double *)at;
    case AS_FLOAT:
        return (double)*(const float *)at;
    case AS_INT:
        return *(const int *)at;
    case AS_LONG:
        return (double)*(const long *)at;
    case AS_U64:
        return (double)*(const uint64_t *)at;
    case AS_SIZE:
        return (double)*(const size_t *)at;
    case AS_BOOL:
        return *(const bool *)at;
    }
    return (double)NAN;
}

// False, and web_error says why, when there is no such name, or its value lies outside what it may be.
bool EXPORT(web_set)(const char *name, double value)
{
    Parameter p;
    page.error.message[0] = '\0';
    if (!find(name, &p))
        return error_set(&page.error, "there is nothing called '%.40s' to be set", name);
    if (!(value >= p.low && value <= p.high))
        return error_set(&page.error, "%s is %g; expected %g to %g", name, value, p.low, p.high);
    char *at = (char *)&page + p.offset;
    switch (p.storage) {
    case AS_DOUBLE:
        *(double *)at = value;
        break;
    case AS_FLOAT:
        *(float *)at = (float)value;
        break;
    case AS_INT:
        *(int *)at = (int)value;
        break;
    case AS_LONG:
        *(long *)at = (long)value;
        break;
    case AS_U64:
        *(uint64_t *)at = (uint64_t)value;
        break;
    case AS_SIZE:
        *(size_t *)at = (size_t)value;
        break;
    case AS_BOOL:
        *(bool *)at = value != 0.0;
        break;
    }
    return true;
}

static void list_names(const char *key, const char *const *names)
{
    text_append(page.text, sizeof page.text, "\"%s\":[", key);
    for (int i = 0; names[i]; i++)
        text_append(page.text, sizeof page.text, "%s\"%s\"", i ? "," : "", names[i]);
    text_append(page.text, sizeof page.text, "],");
}

// JSON: words for the values of view, colour, integrator and radii; the kinds of runs, and of which of them each view shows
// what was found; all parameters with their ranges; of views' settings also kind, key and words.
const char *EXPORT(web_parameters)(void)
{
    static const char *const KINDS[] = {"whole", "number", "switch"};
    Parameter p;
    const ViewSetting *setting;
    char name[64];
    page.text[0] = '\0';
    text_append(page.text, sizeof page.text, "{");
    static const char *const RUNS[] = {"photons", "lobe", "estimates", "disks", "render", NULL};
    const char *shows[VIEW_COUNT + 1] = {NULL};
    for (int i = 0; i < VIEW_COUNT; i++)
        shows[i] = RUNS[view_types[i]->shows];
    list_names("view", view_names);
    list_names("shows", shows);
    list_names("colour", colour_names);
    list_names("integrator", integrator_names);
    list_names("radii", radii_rules);
    list_names("runs", RUNS);
    text_append(page.text, sizeof page.text, "\"parameters\":[");
    for (int i = 0; parameter_at(i, &p, &setting, name); i++) {
        text_append(page.text, sizeof page.text, "%s{\"name\":\"%s\",\"low\":%.9g,\"high\":%.9g,\"value\":%.9g",
                    i ? "," : "", name, p.low, p.high, web_get(name));
        if (setting)
            text_append(page.text, sizeof page.text, ",\"kind\":\"%s\"", KINDS[setting->kind]);
        text_append(page.text, sizeof page.text, "}");
    }
    text_append(page.text, sizeof page.text, "]}");
    return page.text;
}
