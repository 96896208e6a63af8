// Paths as lines; one of them chosen.
#include "preview/view/view_internal.h"

#define DIM 0.18f // of the other paths, beside the chosen one

const PathLeg *path_legs(const Recording *recording, long path, size_t *count)
{
    size_t first = 0;
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
    if (flight < 0.0)
        return 1.0f;
    double length = (double)vec3_length(vec3_sub(leg->to, leg->from));
    double flown = flight - (double)leg->flown;
    if (flown <= 0.0)
        return 0.0f;
    return flown >= length ? 1.0f : (float)(flown / length);
}

// Many short legs crowd inside a stone: they would drown the rest.
static float length_share(const Side *side, const PathLeg *leg)
{
    Box box = bvh_bounds(side->scene->bvh);
    float size = vec3_length(vec3_sub(box.high, box.low));
    float share = vec3_length(vec3_sub(leg->to, leg->from)) / (0.2f * size);
    return fminf(fmaxf(share, 0.12f), 1.0f);
}

static Rgba leg_colour(const Side *side, ColourMode mode, const PathLeg *leg)
{
    Rgba colour = rgba_of_power(leg->power, side->power);
    float strength = fmaxf((float)(colour.r > colour.g ? colour.r : colour.g), (float)colour.b) / 255.0f;
    Hit hit;
    Vec3 way = vec3_sub(leg->to, leg->from);
    float length = vec3_length(way);
    switch (mode) {
    case COLOUR_POWER:
        return colour;
    case COLOUR_PHOTON:
        colour = palette_photon(leg->colour);
        break;
    case COLOUR_BOUNCE:
        colour = palette_bounce(leg->bounce);
        break;
    case COLOUR_MATERIAL: // that it flies to: a leg does not say
        colour = (Rgba){90, 96, 110, 255};
        if (leg->end != LEG_ESCAPED && length > 0.0f) {
            Ray ray = {vec3_along(leg->from, way, 0.5f), vec3_scale(way, 1.0f / length), NO_PRIMITIVE};
            if (scene_intersect(side->scene, &ray, &hit))
                colour = palette_material((int)(hit.material - side->scene->materials));
        }
        break;
    }
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

// So many lines over the view that they stay apart.
static float lines_exposure(const Pane *pane, size_t count)
{
    float room = sqrtf(points_area(pane));
    return fminf(fmaxf(1.8f * room / ((float)count + 1.0f), 0.05f), 0.9f);
}

static void draw_chosen(const Pane *pane, const PathLeg *legs, size_t count)
{
    const View *view = pane->view;
    size_t shown = view->bounce < 0 || (size_t)view->bounce >= count ? count : (size_t)view->bounce + 1;
    Vertices lines = {.items = NULL}, dots = {.items = NULL};
    for (size_t i = 0; i < count; i++) {
        Rgba colour = leg_colour(pane->side, view->colour, &legs[i]);
        colour.a = 255;
        bool present = view->bounce >= 0 && i + 1 == shown;
        if (!present && view->bounce >= 0)
            colour = rgba_fade(colour, i < shown ? 0.75f : 0.22f);
        add_leg(&lines, &legs[i], colour, view->flight);
        if (i < shown && leg_flown(&legs[i], view->flight) > 0.0f) {
            vertices_point(&dots, legs[i].from, i == 0 ? COLOUR_OF_LIGHTS : (Rgba){255, 255, 255, 220});
            if (legs[i].end != LEG_ESCAPED && leg_flown(&legs[i], view->flight) >= 1.0f)
                vertices_point(&dots, legs[i].to, (Rgba){255, 255, 255, 220});
        }
        if (present)
            add_leg(&lines, &legs[i], (Rgba){255, 255, 255, 90}, view->flight);
    }
    Box box = bvh_bounds(pane->scene->bvh);
    DrawStyle line = {.kind = DRAW_LINES, .no_depth = true};
    for (int i = 0; i < 4 && lines.count; i++) { // twice as wide, whichever way it runs
        pane_look_beside(pane, &view->orbit, box, i & 1 ? 0.5f : -0.5f, i & 2 ? 0.5f : -0.5f);
        canvas_draw(pane->canvas, lines.items, lines.count, &line);
    }
    pane_look(pane, &view->orbit, box);
    if (dots.count)
        canvas_draw(pane->canvas, dots.items, dots.count,
                    &(DrawStyle){.no_depth = true, .point_size = floorf(4.0f * pane->scale)});
    vertices_free(&lines);
    vertices_free(&dots);
}

void view_paths_draw(const Pane *pane)
{
    Side *side = pane->side;
    const View *view = pane->view;
    const Recording *recording = &side->recording;
    size_t count = 0;
    const PathLeg *chosen = view->path >= 0 ? path_legs(recording, view->path, &count) : NULL;
    const double key[KEY_SIZE] = {view->colour, view->flight};
    if (!cache_is(&side->paths, key)) {
        Vertices list = {.items = NULL};
        for (size_t i = 0; i < recording->leg_count; i++)
            add_leg(
                &list, &recording->legs[i],
                rgba_fade(leg_colour(side, view->colour, &recording->legs[i]), length_share(side, &recording->legs[i])),
                view->flight);
        cache_fill(pane->canvas, &side->paths, &list);
    }
    float exposure = lines_exposure(pane, recording->leg_count) * (chosen ? DIM : 1.0f);
    pane_look(pane, &view->orbit, bvh_bounds(pane->scene->bvh));
    batch_draw(pane->canvas, side->paths.batch, 0, batch_count(side->paths.batch),
               &(DrawStyle){.kind = DRAW_LINES, .additive = true, .no_depth = true, .exposure = exposure});
    if (chosen)
        draw_chosen(pane, chosen, count);
}
