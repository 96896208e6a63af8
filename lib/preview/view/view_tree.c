// Cells of the photon map's kd-tree.
#include "photons/photon_map_internal.h"
#include "preview/view/view_internal.h"

#include <stdio.h>
#include <stdlib.h>

enum { LEVEL };         // settings: depth of the cells
enum { BOXES, POINTS }; // lists
typedef struct {
    int level;
    size_t largest; // photons in the fullest cell
} Found;

#define GOLDEN 0.618034f // neighbours' hues lie far apart

int tree_depth(const PhotonMap *map)
{
    return map->depth;
}

Box tree_cell(const PhotonMap *map, int level, size_t i, size_t *count)
{
    int below = map->depth - level;
    size_t begin = leaf_begin(map, i << below), end = leaf_begin(map, (i + 1) << below);
    Box box = box_empty();
    for (size_t p = begin; p < end; p++)
        box_add_point(&box, map->photons[p].position);
    *count = end - begin;
    return box;
}

// A map of the photons; without those that no map takes.
static PhotonMap *build_map(const Recording *recording)
{
    StoredPhoton *photons = malloc((recording->count + 1) * sizeof *photons);
    size_t count = 0;
    Error error;
    for (size_t i = 0; photons && i < recording->count; i++) {
        Vec3 p = recording->photons[i].at.position;
        if (fabsf(p.x) < 1e18f && fabsf(p.y) < 1e18f && fabsf(p.z) < 1e18f)
            photons[count++] = recording->photons[i].at;
    }
    return photons ? photon_map_build(photons, count, &error) : NULL;
}

static void build(const View *view, ViewData *data, Vertices *lists)
{
    Found *found = data->made[VIEW_TREE].found;
    if (!data->map)
        data->map = build_map(&data->recording);
    if (!data->map)
        return;
    const StoredPhoton *photon = photon_map_photons(data->map);
    found->level = (int)fmin(view->settings[VIEW_TREE][LEVEL], tree_depth(data->map));
    found->largest = 0;
    vertices_reserve(&lists[POINTS], data->recording.count);
    for (size_t i = 0; i < (size_t)1 << found->level; i++) {
        size_t count;
        Box box = tree_cell(data->map, found->level, i, &count);
        Rgba hue = palette_hue(GOLDEN * (float)i);
        if (count)
            vertices_box(&lists[BOXES], box, hue);
        for (size_t p = 0; p < count; p++)
            vertices_point(&lists[POINTS], (photon++)->position, hue);
        found->largest = count > found->largest ? count : found->largest;
    }
}

static void draw(const Pane *pane)
{
    const VertexBuffer *lists = pane->data->made[VIEW_TREE].lists;
    float area = points_area(pane);
    float strength = fminf(fmaxf(40.0f * sqrtf(area) / ((float)lists[BOXES].count + 1.0f), 0.1f), 0.6f);
    pane_look_at_scene(pane);
    // The photons lie in the order of cells: no first part of them is a fair sample, so all are drawn.
    pane_draw_points(pane, POINTS, lists[POINTS].count, area, 0.6f);
    pane_draw(pane, BOXES, (DrawStyle){.kind = DRAW_LINES, .additive = true, .exposure = strength});
}

static void describe(const View *view, const ViewData *data, char *text, size_t size)
{
    (void)view;
    const Found *found = data->made[VIEW_TREE].found;
    size_t cells = (size_t)1 << found->level;
    if (!data->map)
        snprintf(text, size, "no photons, no tree");
    else
        snprintf(text, size, "kd-tree after %d halvings of at most %d: %zu cell%s, %zu photons in the fullest",
                 found->level, tree_depth(data->map), cells, cells == 1 ? "" : "s", found->largest);
}

static void choose(View *view, const ViewData *data, bool sideways, int step)
{
    (void)data;
    double *level = &view->settings[VIEW_TREE][LEVEL];
    if (!sideways)
        *level = fmin(fmax(*level + step, 0.0), 24.0);
}

const ViewType view_tree = {
    .help = "cells of the photon map; --level N halvings deep\n",
    .arrows = "depth",
    .place = IN_THE_SCENE,
    .wires = 0.45f,
    .settings = {{.flag = "level", .kind = SETTING_WHOLE, .start = 8, .low = 0, .high = 30}},
    .build = build,
    .draw = draw,
    .describe = describe,
    .legend = NULL, // a hue for each cell
    .choose = choose,
    .found_size = sizeof(Found),
};
