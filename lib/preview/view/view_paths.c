// Paths as lines; one of them chosen.
#include "preview/view/view_internal.h"
#include "scene/limits.h"

#include <stdio.h>

enum { PATH, BOUNCE }; // settings: the chosen path, −1: all alike; of it, legs up to this one are bright, −1: all
enum { LINES, CHOSEN, ENDS }; // lists: all paths; the chosen one, and where its legs end

#define DIM 0.18f // of the other paths, beside the chosen one

const PathLeg *path_legs(const Recording *recording, long path, size_t *count)
{
    size_t first = path < 0 ? recording->leg_count : 0;
    while (first < recording->leg_count && (long)recording->legs[first].path != path)
        first++;
    size_t end = first;
    while (end < recording->leg_count && (long)recording->legs[end].path == path)
        end++;
    *count = end - first;
    return *count ? &recording->legs[first] : NULL;
}

float leg_flown(const PathLeg *leg, double flight)
{
    double flown = (flight - (double)leg->flown) / (double)leg_length(leg);
    return flight < 0.0 ? 1.0f : (float)fmin(fmax(flown, 0.0), 1.0);
}

// The material that it flies to: a leg does not say.
static Rgba colour_ahead(const Scene *scene, const PathLeg *leg)
{
    Vec3 way = vec3_sub(leg->to, leg->from);
    float length = vec3_length(way);
    Ray ray = {vec3_along(leg->from, way, 0.5f), vec3_scale(way, 1.0f / length), NO_PRIMITIVE};
    Hit hit;
    if (leg->end == LEG_ESCAPED || !(length > 0.0f) || !scene_intersect(scene, &ray, &hit))
        return (Rgba){90, 96, 110, 255};
    return palette_material((int)(hit.material - scene->materials));
}

static Rgba leg_colour(const ViewData *data, ColourMode mode, const PathLeg *leg)
{
    Rgba light = rgba_of_power(leg->power, data->power);
    if (mode == COLOUR_POWER)
        return light;
    float strength = fmaxf((float)(light.r > light.g ? light.r : light.g), (float)light.b) / 255.0f;
    Rgba colour = mode == COLOUR_PHOTON   ? palette_photon(leg->colour)
                  : mode == COLOUR_BOUNCE ? palette_bounce(leg->bounce)
                                          : colour_ahead(data->scene, leg);
    return rgba_fade(colour, 0.35f + 0.65f * strength);
}

// The part of a leg that has been flown; the light's front is bright.
static void add_leg(Vertices *list, const PathLeg *leg, Rgba colour, double flight)
{
    float flown = leg_flown(leg, flight);
    if (!(flown > 0.0f) || !isfinite(vec3_dot(leg->from, leg->from) + vec3_dot(leg->to, leg->to)))
        return;
    Vec3 way = vec3_sub(leg->to, leg->from);
    Rgba end = leg->end == LEG_ESCAPED ? rgba_fade(colour, 1.0f - flown) : colour;
    vertices_fading(list, leg->from, vec3_along(leg->from, way, flown), colour, end);
    if (flown >= 1.0f)
        return;
    float length = vec3_length(way), head = fminf(flown, 0.02f / fmaxf(length, 1e-6f));
    Rgba bright = {255, 255, 235, 255};
    vertices_fading(list, vec3_along(leg->from, way, flown - head), vec3_along(leg->from, way, flown),
                    rgba_fade(bright, 0.2f), bright);
}

// The last of the bright legs.
static size_t present_leg(const View *view, size_t count)
{
    double bounce = view->settings[VIEW_PATHS][BOUNCE];
    return bounce < 0.0 || bounce >= (double)count ? count - 1 : (size_t)bounce;
}

static void build_chosen(const View *view, const ViewData *data, const PathLeg *legs, size_t count, Vertices *lists)
{
    bool chosen = view->settings[VIEW_PATHS][BOUNCE] >= 0.0;
    size_t shown = present_leg(view, count) + 1;
    for (size_t i = 0; i < count; i++) {
        Rgba colour = leg_colour(data, view->colour, &legs[i]);
        colour.a = 255;
        bool present = chosen && i + 1 == shown;
        if (!present && chosen)
            colour = rgba_fade(colour, i < shown ? 0.75f : 0.22f);
        add_leg(&lists[CHOSEN], &legs[i], colour, view->flight);
        if (i < shown && leg_flown(&legs[i], view->flight) > 0.0f) {
            vertices_point(&lists[ENDS], legs[i].from, i == 0 ? COLOUR_OF_LIGHTS : (Rgba){255, 255, 255, 220});
            if (legs[i].end != LEG_ESCAPED && leg_flown(&legs[i], view->flight) >= 1.0f)
                vertices_point(&lists[ENDS], legs[i].to, (Rgba){255, 255, 255, 220});
        }
        if (present)
            add_leg(&lists[CHOSEN], &legs[i], (Rgba){255, 255, 255, 90}, view->flight);
    }
}

static void build(const View *view, ViewData *data, Vertices *lists)
{
    const Recording *recording = &data->recording;
    float size = box_diagonal(bvh_bounds(data->scene->bvh));
    size_t count;
    for (size_t i = 0; i < recording->leg_count; i++) {
        const PathLeg *leg = &recording->legs[i];
        float share =
            leg_length(leg) / (0.2f * size); // many short legs crowd inside a stone: they would drown the rest
        Rgba colour = rgba_fade(leg_colour(data, view->colour, leg), fminf(fmaxf(share, 0.12f), 1.0f));
        add_leg(&lists[LINES], leg, colour, view->flight);
    }
    const PathLeg *legs = path_legs(recording, (long)view->settings[VIEW_PATHS][PATH], &count);
    build_chosen(view, data, legs, count, lists);
}

static void draw(const Pane *pane)
{
    const View *view = pane->view;
    const Recording *recording = &pane->data->recording;
    size_t count;
    bool chosen = path_legs(recording, (long)view->settings[VIEW_PATHS][PATH], &count);
    // So many lines lie over each other at a place: the more, the more transparent each.
    float crossing = 0.4f * (float)recording->leg_count / sqrtf(points_area(pane));
    float opacity = fminf(fmaxf(view_brightness(view) * 0.9f / (1.0f + 3.5f * crossing), 0.03f), 1.0f);
    pane_look_at_scene(pane);
    pane_draw(pane, LINES, (DrawStyle){.kind = DRAW_LINES, .opacity = opacity * (chosen ? DIM : 1.0f)});
    Box box = bvh_bounds(pane->data->scene->bvh);
    for (int i = 0; i < 4; i++) { // twice as wide, whichever way it runs
        pane_look(pane, &view->orbit, box, i & 1 ? 0.5f : -0.5f, i & 2 ? 0.5f : -0.5f);
        pane_draw(pane, CHOSEN, (DrawStyle){.kind = DRAW_LINES});
    }
    pane_look_at_scene(pane);
    pane_draw(pane, ENDS, (DrawStyle){.point_size = floorf(4.0f * pane->scale)});
}

static void describe(const View *view, const ViewData *data, char *text, size_t size)
{
    long path = (long)view->settings[VIEW_PATHS][PATH];
    size_t count;
    const PathLeg *legs = path_legs(&data->recording, path, &count);
    if (path < 0) {
        snprintf(text, size, "paths of the first %ld photons, coloured by %s", data->recording.recorded,
                 colour_names[view->colour]);
        return;
    }
    if (!legs) {
        snprintf(text, size, "photon %ld: no path", path);
        return;
    }
    static const char *const FATES[] = {"lands", "meets a lamp", "leaves the scene"};
    size_t present = present_leg(view, count);
    const PathLeg *leg = &legs[present];
    snprintf(
        text, size,
        "photon %ld, leg %zu of %zu: after %u bounce%s, %s, %.3g W\nred %.3g, green %.3g, blue %.3g W\n%s after %.3g m",
        path, present + 1, count, leg->bounce, leg->bounce == 1 ? "" : "s", photon_colour_name(leg->colour),
        (double)colour_sum(leg->power), (double)leg->power.r, (double)leg->power.g, (double)leg->power.b,
        FATES[leg->end <= LEG_ESCAPED ? leg->end : 0], (double)(leg->flown + leg_length(leg)));
}

static void choose(View *view, const ViewData *data, bool sideways, int step)
{
    double *settings = view->settings[VIEW_PATHS];
    if (sideways) {
        settings[PATH] = wrap(settings[PATH] + step, -1.0, (double)(data->recording.recorded - 1));
        settings[BOUNCE] = -1.0;
    } else if (settings[PATH] >= 0.0) {
        settings[BOUNCE] = fmax(settings[BOUNCE] + step, -1.0);
    }
}

const ViewType view_paths = {
    .help = "the first paths as lines; --path I chooses one, --bounce B its legs up to that one\n",
    .arrows = "photon, bounce",
    .place = IN_THE_SCENE,
    .wires = 0.75f,
    .in_flight = true,
    .settings = {{.flag = "path", .kind = SETTING_WHOLE, .start = -1, .low = 0, .high = MOST_PHOTONS},
                 {.flag = "bounce", .kind = SETTING_WHOLE, .start = -1, .low = 0, .high = MOST_DEPTH}},
    .build = build,
    .draw = draw,
    .describe = describe,
    .legend = legend_of_photons,
    .choose = choose,
};
