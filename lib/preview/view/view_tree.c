// Cells of the photon map's kd-tree.
#include "photons/photon_map_internal.h"
#include "preview/view/view_internal.h"

#include <stdlib.h>

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

// A map of the side's photons; without those that no map takes.
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

static void build(Side *side, int level)
{
    Vertices boxes = {.items = NULL}, points = {.items = NULL};
    const StoredPhoton *photon = photon_map_photons(side->map);
    side->cell_level = level;
    side->cells = (size_t)1 << level;
    side->largest_cell = 0;
    vertices_reserve(&points, photon_map_count(side->map));
    for (size_t i = 0; i < side->cells; i++) {
        size_t count;
        Box box = tree_cell(side->map, level, i, &count);
        Rgba hue = palette_hue(GOLDEN * (float)i);
        if (count)
            vertices_box(&boxes, box, hue);
        for (size_t p = 0; p < count; p++)
            vertices_point(&points, (photon++)->position, hue);
        side->largest_cell = count > side->largest_cell ? count : side->largest_cell;
    }
    cache_fill(side->canvas, &side->tree, &boxes);
    cache_fill(side->canvas, &side->tree_points, &points);
}

void view_tree_draw(const Pane *pane)
{
    Side *side = pane->side;
    if (!side->map && !(side->map = build_map(&side->recording)))
        return;
    int level = pane->view->level < tree_depth(side->map) ? pane->view->level : tree_depth(side->map);
    const double key[KEY_SIZE] = {level};
    if (!cache_is(&side->tree, key))
        build(side, level < 0 ? 0 : level);
    size_t count = batch_count(side->tree_points.batch), lines = batch_count(side->tree.batch);
    float area = points_area(pane), size = points_size(count, area, pane->scale);
    float exposure = points_exposure(count, area, size);
    pane_look(pane, &pane->view->orbit, bvh_bounds(pane->scene->bvh));
    // The photons lie in the order of cells: no first part of them is a fair sample, so all are drawn.
    batch_draw(pane->canvas, side->tree_points.batch, 0, count,
               &(DrawStyle){.additive = true, .no_depth = true, .point_size = size, .exposure = 0.6f * exposure});
    float strength = fminf(fmaxf(40.0f * sqrtf(area) / ((float)lines + 1.0f), 0.1f), 0.6f);
    batch_draw(pane->canvas, side->tree.batch, 0, lines,
               &(DrawStyle){.kind = DRAW_LINES, .additive = true, .no_depth = true, .exposure = strength});
}
