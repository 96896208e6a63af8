// The view in words.
#include "preview/view/view_internal.h"

#include <stdio.h>

static void describe_points(const View *view, const Side *side, char *text, size_t size)
{
    snprintf(text, size, "photons where they landed, coloured by %s", colour_mode_name(view->colour));
    if (view->flight >= 0.0) {
        size_t count = 0;
        for (size_t i = 0; i < side->recording.count; i++)
            count += (double)side->recording.photons[i].flown <= view->flight;
        snprintf(text, size, "after %.2f m of flight: %zu of %zu photons have landed", view->flight, count,
                 side->recording.count);
    }
}

static void describe_paths(const View *view, const Side *side, char *text, size_t size)
{
    const Recording *recording = &side->recording;
    size_t count;
    const PathLeg *legs = view->path >= 0 ? path_legs(recording, view->path, &count) : NULL;
    if (view->path < 0) {
        snprintf(text, size, "paths of the first %ld photons, coloured by %s", recording->recorded,
                 colour_mode_name(view->colour));
        return;
    }
    if (!legs) {
        snprintf(text, size, "photon %ld: no path", view->path);
        return;
    }
    bool all = view->bounce < 0 || (size_t)view->bounce >= count;
    size_t present = all ? count - 1 : (size_t)view->bounce;
    const PathLeg *leg = &legs[present];
    static const char *const ENDS[] = {"lands", "meets a lamp", "leaves the scene"};
    snprintf(
        text, size,
        "photon %ld, leg %zu of %zu: after %u bounce%s, %s, %.3g W\nred %.3g, green %.3g, blue %.3g W\n%s after %.3g m",
        view->path, present + 1, count, leg->bounce, leg->bounce == 1 ? "" : "s", photon_colour_name(leg->colour),
        (double)colour_sum(leg->power), (double)leg->power.r, (double)leg->power.g, (double)leg->power.b,
        ENDS[leg->end <= LEG_ESCAPED ? leg->end : 0], (double)(leg->flown + vec3_length(vec3_sub(leg->to, leg->from))));
}

static void describe_lobe(const View *view, const Side *side, char *text, size_t size)
{
    size_t count = side->lobe.count;
    const char *step = view->diffuse ? "1.3" : side->recording.play.glossy == GLOSSY_PHONG ? "2.4" : "2.3";
    const StepState state = side->recording.states[step_find(step) - step_table];
    const char *whose = state == STEP_STUDENT       ? ", yours"
                        : state == STEP_NOT_STARTED ? ", the reference's"
                                                    : ""; // nobody else is there
    int length;
    if (view->diffuse)
        length = snprintf(text, size, "diffuse, step %s%s: density cos(theta)/pi", step, whose);
    else
        length = snprintf(text, size, "glossy, step %s%s: exponent %.4g, %.4g degrees", step, whose,
                          (double)view->exponent, (double)view->angle);
    if (length > 0 && (size_t)length < size)
        length += snprintf(text + length, size - (size_t)length, "\n%zu samples, %.1f %% absorbed", count,
                           count ? 100.0 * (double)side->lobe_absorbed / (double)count : 0.0);
    if (side->lobe_below && (size_t)length < size)
        length +=
            snprintf(text + length, size - (size_t)length, "\n%zu point into the surface (red)", side->lobe_below);
    if (side->lobe_long && (size_t)length < size)
        snprintf(text + length, size - (size_t)length, "\n%zu are not of unit length (drawn at theirs)",
                 side->lobe_long);
}

static void describe_screen(const View *view, const Scene *scene, const Side *side, char *text, size_t size)
{
    int surface = view->surface >= 0 ? view->surface : side->screen_surface;
    if (surface < 0 || (size_t)surface >= scene->flat_count) {
        snprintf(text, size, surface < 0 ? "no photon has landed on a flat surface" : "the scene has %zu flat surfaces",
                 scene->flat_count);
        return;
    }
    const Flat *flat = &scene->flats[surface];
    snprintf(text, size, "surface %d, %s, %.3g x %.3g m: %zu photons%s", surface, scene->materials[flat->material].name,
             (double)fmaxf(vec3_length(flat->edge_u), vec3_length(flat->edge_v)),
             (double)fminf(vec3_length(flat->edge_u), vec3_length(flat->edge_v)), side->arrivals,
             view->surface < 0 ? " (the busiest)" : "");
}

static void describe_tree(const Side *side, char *text, size_t size)
{
    if (!side->map)
        snprintf(text, size, "no photons, no tree");
    else
        snprintf(text, size, "kd-tree after %d halvings of at most %d: %zu cell%s, %zu photons in the fullest",
                 side->cell_level, tree_depth(side->map), side->cells, side->cells == 1 ? "" : "s", side->largest_cell);
}

void view_describe(const View *view, const Scene *scene, const Side *yours, char *text, size_t size)
{
    switch (view->kind) {
    case VIEW_POINTS:
        describe_points(view, yours, text, size);
        return;
    case VIEW_PATHS:
        describe_paths(view, yours, text, size);
        return;
    case VIEW_LOBE:
        describe_lobe(view, yours, text, size);
        return;
    case VIEW_SCREEN:
        describe_screen(view, scene, yours, text, size);
        return;
    case VIEW_TREE:
        describe_tree(yours, text, size);
        return;
    }
    text[0] = '\0';
}
