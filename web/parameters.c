// Everything that JavaScript may set and ask for, by name: one table, of which the page makes its controls, and a link that
// holds them all.
#include "web/web.h"

#include "base/text.h"
#include "scene/limits.h"

#include <stddef.h>
#include <stdio.h>

typedef enum { AS_DOUBLE, AS_FLOAT, AS_INT, AS_SIZE, AS_BOOL } Storage;
typedef struct {
    const char *name;
    size_t offset; // in Page
    Storage storage;
    double low, high;
    bool of_photons; // photons collected before are of another setting
} Parameter;

#define IN(member) offsetof(Page, member)
static const Parameter PARAMETERS[] = {
    {"photons", IN(asked.photons), AS_DOUBLE, 1, MOST_PHOTONS, true},
    {"depth", IN(asked.depth), AS_DOUBLE, 1, MOST_DEPTH, true},
    {"seed", IN(asked.seed), AS_DOUBLE, 0, 1e15, true},
    {"paths", IN(asked.recorded), AS_DOUBLE, 0, 1e6, true},
    {"spectral", IN(asked.spectral), AS_DOUBLE, 0, 1, true},
    {"view", IN(view.kind), AS_INT, 0, VIEW_COUNT - 1, false},
    {"colour", IN(view.colour), AS_INT, 0, COLOUR_COUNT - 1, false},
    {"wireframe", IN(view.wireframe), AS_BOOL, 0, 1, false},
    {"flight", IN(view.flight), AS_DOUBLE, -1, SCENE_LARGEST_NUMBER, false},
    {"most_points", IN(view.most_points), AS_SIZE, 0, MOST_PHOTONS, false},
    {"target_x", IN(view.orbit.target.x), AS_FLOAT, -SCENE_LARGEST_NUMBER, SCENE_LARGEST_NUMBER, false},
    {"target_y", IN(view.orbit.target.y), AS_FLOAT, -SCENE_LARGEST_NUMBER, SCENE_LARGEST_NUMBER, false},
    {"target_z", IN(view.orbit.target.z), AS_FLOAT, -SCENE_LARGEST_NUMBER, SCENE_LARGEST_NUMBER, false},
    {"distance", IN(view.orbit.distance), AS_FLOAT, SCENE_SMALLEST_LENGTH, SCENE_LARGEST_NUMBER, false},
    {"yaw", IN(view.orbit.yaw), AS_FLOAT, -SCENE_LARGEST_NUMBER, SCENE_LARGEST_NUMBER, false},
    {"pitch", IN(view.orbit.pitch), AS_FLOAT, -PI / 2, PI / 2, false},
    {"vertical_fov", IN(view.orbit.vertical_fov), AS_FLOAT, 1, 170, false},
    {"zoom", IN(view.framing.zoom), AS_FLOAT, LEAST_ZOOM, MOST_ZOOM, false},
    {"right", IN(view.framing.right), AS_FLOAT, -1e6, 1e6, false},
    {"up", IN(view.framing.up), AS_FLOAT, -1e6, 1e6, false},
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
                *found = (Parameter){name, IN(view.settings[view][j]), AS_DOUBLE, fmin(s->start, s->low), high, false};
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
    case AS_SIZE:
        *(size_t *)at = (size_t)value;
        break;
    case AS_BOOL:
        *(bool *)at = value != 0.0;
        break;
    }
    if (p.of_photons)
        web_forget();
    return true;
}

static void list_names(const char *key, const char *const *names)
{
    text_append(page.text, sizeof page.text, "\"%s\":[", key);
    for (int i = 0; names[i]; i++)
        text_append(page.text, sizeof page.text, "%s\"%s\"", i ? "," : "", names[i]);
    text_append(page.text, sizeof page.text, "],");
}

// JSON: views, colours, and all parameters with their ranges; of views' settings also kind, key and words.
const char *EXPORT(web_parameters)(void)
{
    static const char *const KINDS[] = {"whole", "number", "switch"};
    Parameter p;
    const ViewSetting *setting;
    char name[64];
    page.text[0] = '\0';
    text_append(page.text, sizeof page.text, "{");
    list_names("views", view_names);
    list_names("colours", colour_names);
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
