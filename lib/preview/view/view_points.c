// Stored photons as points of light.
#include "preview/view/view_internal.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Caches and ViewType.found of this view.
enum { POINTS };
typedef struct {
    float *flown; // of the points, in their order, where they are sorted by it
} Found;

#define MIDDLE_BRIGHTNESS 0.42f // that so many photons over so many pixels add up to
#define LEAST_EXPOSURE    0.035f

float points_exposure(size_t count, float pixels, float point_size)
{
    float covered = (float)count * point_size * point_size;
    float exposure = covered > 0.0f ? MIDDLE_BRIGHTNESS * pixels / covered : 1.0f;
    return fminf(fmaxf(exposure, LEAST_EXPOSURE), 1.0f);
}

float points_size(size_t count, float pixels, float scale)
{
    float size = floorf(sqrtf(0.5f * pixels / ((float)count + 1.0f)) + 0.5f);
    return fminf(fmaxf(size, 1.0f), 2.0f + scale);
}

float points_area(const Pane *pane)
{
    Box box = bvh_bounds(pane->scene->bvh);
    float across = vec3_length(vec3_sub(box.high, box.low)) / 1.732f;
    float tan_half = tanf(0.5f * pane->view->orbit.vertical_fov * (PI / 180.0f));
    float high = across / (2.0f * pane->view->orbit.distance * tan_half) * (float)pane->height;
    if (!(high > 1.0f)) // an empty box, too
        high = 1.0f;
    return fminf(high * high, (float)pane->width * (float)pane->height); // what lies outside is not seen
}

Rgba points_colour(const ViewData *data, ColourMode mode, const StoredPhoton *photon)
{
    switch (mode) {
    case COLOUR_PHOTON:
        return palette_photon(photon->colour);
    case COLOUR_BOUNCE:
        return palette_bounce(photon->bounce);
    case COLOUR_MATERIAL:
        return palette_material(photon->material);
    case COLOUR_POWER:
        break;
    }
    return rgba_of_power(photon->power, data->power);
}

static int by_flight(const void *a, const void *b)
{
    float x = ((const RecordedPhoton *)a)->flown, y = ((const RecordedPhoton *)b)->flown;
    return x < y ? -1 : x > y;
}

// The first photons in the order of flight. NULL when memory is short.
static RecordedPhoton *sorted_by_flight(const RecordedPhoton *photons, size_t count)
{
    RecordedPhoton *sorted = malloc((count + 1) * sizeof *sorted);
    if (sorted && count)
        memcpy(sorted, photons, count * sizeof *sorted);
    if (sorted)
        qsort(sorted, count, sizeof *sorted, by_flight);
    return sorted;
}

// Photons as vertices. `sorted`: by the way that they have flown, which is kept.
static void build(ViewData *data, ColourMode mode, const RecordedPhoton *photons, size_t count, bool sorted)
{
    Found *found = data->found[VIEW_POINTS];
    Vertices list = {.items = NULL};
    free(found->flown);
    found->flown = sorted ? malloc((count + 1) * sizeof *found->flown) : NULL;
    if (!vertices_reserve(&list, count))
        count = 0;
    for (size_t i = 0; i < count; i++) {
        vertices_point(&list, photons[i].at.position, points_colour(data, mode, &photons[i].at));
        if (found->flown)
            found->flown[i] = photons[i].flown;
    }
    cache_fill(data->canvas, &data->caches[VIEW_POINTS][POINTS], &list);
}

// How many of the sorted photons have flown no farther.
static size_t arrived(const float *flown, size_t count, double flight)
{
    size_t low = 0, high = flown ? count : 0;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if ((double)flown[middle] <= flight)
            low = middle + 1;
        else
            high = middle;
    }
    return flown ? low : count;
}

static void draw(const Pane *pane)
{
    ViewData *data = pane->data;
    const View *view = pane->view;
    size_t count = data->recording.count, most = view->most_points;
    size_t drawn = most > 0 && most < count ? most : count;
    bool sorted = view->flight >= 0.0;
    Cache *points = &data->caches[VIEW_POINTS][POINTS];
    // Sorted, only the photons drawn are there; else all, and a first part of them is drawn.
    const double key[KEY_SIZE] = {data->recordings, view->colour, sorted, sorted ? (double)drawn : 0.0};
    if (!cache_is(points, key)) {
        RecordedPhoton *first = sorted ? sorted_by_flight(data->recording.photons, drawn) : NULL;
        build(data, view->colour, first ? first : data->recording.photons, first ? drawn : count, first != NULL);
        free(first);
    }
    float area = points_area(pane), size = points_size(drawn, area, pane->scale);
    float exposure = points_exposure(drawn, area, size);
    if (sorted)
        drawn = arrived(((Found *)data->found[VIEW_POINTS])->flown, drawn, view->flight);
    pane_look_at_scene(pane);
    pane_draw_cache(pane, points, 0, drawn, (DrawStyle){.additive = true, .exposure = exposure, .point_size = size});
}

static void describe(const View *view, const ViewData *data, char *text, size_t size)
{
    if (view->flight < 0.0) {
        snprintf(text, size, "photons where they landed, coloured by %s", colour_mode_name(view->colour));
        return;
    }
    size_t count = 0;
    for (size_t i = 0; i < data->recording.count; i++)
        count += (double)data->recording.photons[i].flown <= view->flight;
    snprintf(text, size, "after %.2f m of flight: %zu of %zu photons have landed", view->flight, count,
             data->recording.count);
}

static void free_found(void *found)
{
    free(((Found *)found)->flown);
}

const ViewType view_points = {
    .name = "points",
    .help = "stored photons (default)\n",
    .place = IN_THE_SCENE,
    .wires = 0.75f,
    .in_flight = true,
    .draw = draw,
    .describe = describe,
    .legend = legend_of_photons,
    .found_size = sizeof(Found),
    .free_found = free_found,
};
