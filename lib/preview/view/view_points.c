// Stored photons as points of light.
#include "preview/view/view_internal.h"

#include <stdio.h>

enum { POINTS }; // lists

#define MIDDLE_BRIGHTNESS 0.42f // that so many photons over so many pixels add up to
#define LEAST_EXPOSURE    0.035f

float points_exposure(size_t count, float pixels, float point_size)
{
    float covered = (float)count * point_size * point_size;
    float exposure = covered > 0.0f ? MIDDLE_BRIGHTNESS * pixels / covered : 1.0f;
    return fminf(fmaxf(exposure, LEAST_EXPOSURE), 1.0f);
}

void pane_draw_points(const Pane *pane, int list, size_t count, float area, float strength)
{
    float size = floorf(sqrtf(0.5f * area / ((float)count + 1.0f)) + 0.5f);
    size = fminf(fmaxf(size, 1.0f), 2.0f + pane->scale);
    float exposure = strength * points_exposure(count, area, size);
    vertex_buffer_draw(pane->data->canvas, &pane->data->made[pane->view->kind].lists[list], 0, count,
                       &(DrawStyle){.additive = true, .exposure = exposure, .point_size = size});
}

size_t points_drawn(const View *view, size_t count)
{
    return view->most_points > 0 && view->most_points < count ? view->most_points : count;
}

float points_area(const Pane *pane)
{
    float across = box_diagonal(bvh_bounds(pane->data->scene->bvh)) / 1.732f;
    float tan_half = tanf(0.5f * pane->view->orbit.vertical_fov * (PI / 180.0f));
    float high = across / (2.0f * pane->view->orbit.distance * tan_half) * (float)pane->height;
    if (!(high > 1.0f)) // an empty box, too
        high = 1.0f;
    return fminf(high * high, (float)pane->width * (float)pane->height); // what lies outside is not seen
}

Rgba points_colour(const ViewData *data, ColourMode mode, const StoredPhoton *photon)
{
    return mode == COLOUR_PHOTON     ? palette_photon(photon->colour)
           : mode == COLOUR_BOUNCE   ? palette_bounce(photon->bounce)
           : mode == COLOUR_MATERIAL ? palette_material(photon->material)
                                     : rgba_of_power(photon->power, data->power);
}

// Of light in flight, only the photons drawn are there; else all, and a first part of them is drawn.
static void build(const View *view, ViewData *data, Vertices *lists)
{
    const Recording *recording = &data->recording;
    bool flying = view->flight >= 0.0;
    size_t count = flying ? points_drawn(view, recording->count) : recording->count;
    vertices_reserve(&lists[POINTS], count);
    for (size_t i = 0; i < count; i++) {
        const RecordedPhoton *photon = &recording->photons[i];
        if (!flying || (double)photon->flown <= view->flight)
            vertices_point(&lists[POINTS], photon->at.position, points_colour(data, view->colour, &photon->at));
    }
}

static void draw(const Pane *pane)
{
    size_t drawn = points_drawn(pane->view, pane->data->recording.count);
    pane_look_at_scene(pane);
    pane_draw_points(pane, POINTS, drawn, points_area(pane), view_brightness(pane->view));
}

static void describe(const View *view, const ViewData *data, char *text, size_t size)
{
    if (view->flight < 0.0) {
        snprintf(text, size, "photons where they landed, coloured by %s", colour_names[view->colour]);
        return;
    }
    size_t count = 0;
    for (size_t i = 0; i < data->recording.count; i++)
        count += (double)data->recording.photons[i].flown <= view->flight;
    snprintf(text, size, "after %.2f m of flight: %zu of %zu photons have landed", view->flight, count,
             data->recording.count);
}

const ViewType view_points = {
    .help = "stored photons (default)\n",
    .place = IN_THE_SCENE,
    .wires = 0.75f,
    .in_flight = true,
    .build = build,
    .draw = draw,
    .describe = describe,
    .legend = legend_of_photons,
};
