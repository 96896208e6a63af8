// Stored photons as points of light.
#include "preview/view/view_internal.h"

#include <stdio.h>
#include <stdlib.h>

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

static uint32_t float_order(float value)
{
    union {
        float value;
        uint32_t bits;
    } as = {value > 0.0f ? value : 0.0f};
    return as.bits;
}

// Indices of photons by the way flown: by 11 bits at a time. NULL when memory is short.
static uint32_t *order_by_flight(const RecordedPhoton *photons, size_t count)
{
    uint32_t *order = malloc((count + 1) * sizeof *order), *other = malloc((count + 1) * sizeof *other);
    for (size_t i = 0; order && i < count; i++)
        order[i] = (uint32_t)i;
    for (int shift = 0; order && other && shift < 32; shift += 11) {
        size_t begin[2049] = {0};
        for (size_t i = 0; i < count; i++)
            begin[(float_order(photons[order[i]].flown) >> shift & 2047) + 1]++;
        for (int b = 0; b < 2048; b++)
            begin[b + 1] += begin[b];
        for (size_t i = 0; i < count; i++)
            other[begin[float_order(photons[order[i]].flown) >> shift & 2047]++] = order[i];
        uint32_t *swap = order;
        order = other;
        other = swap;
    }
    free(other);
    return order;
}

// The photons `which` (NULL: the first ones) as vertices.
static void build(ViewData *data, ColourMode mode, const uint32_t *which, size_t count)
{
    Found *found = data->found[VIEW_POINTS];
    Vertices list = {.items = NULL};
    free(found->flown);
    found->flown = which ? malloc((count + 1) * sizeof *found->flown) : NULL;
    if (!vertices_reserve(&list, count))
        count = 0;
    for (size_t i = 0; i < count; i++) {
        const RecordedPhoton *photon = &data->recording.photons[which ? which[i] : i];
        Vec3 at = photon->at.position;
        Rgba colour = points_colour(data, mode, &photon->at);
        list.items[i] = (Vertex){at.x, at.y, at.z, colour.r, colour.g, colour.b, colour.a};
        if (found->flown)
            found->flown[i] = photon->flown;
    }
    list.count = count;
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
        uint32_t *order = sorted ? order_by_flight(data->recording.photons, drawn) : NULL;
        build(data, view->colour, order, order ? drawn : count);
        free(order);
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
