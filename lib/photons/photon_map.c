// A reading order through the kd-tree, for chapter 1 of the notes.
//
// The plain idea. Halve the photons at the median of one coordinate, halve the halves along another, and so on, until a
// part holds a handful. To find the photons near a point, go down to the part that the point lies in; on the way back
// enter the other half of a split only if it can hold anything nearer than the farthest of those found. Textbooks keep
// one photon and one splitting plane in a node, two pointers to the halves, and the k nearest so far in a heap.
//
// Ours is the same tree, for a machine that computes quickly and waits long for memory:
//   1. photon_map_internal.h: how it lies in memory. No pointers: the halving is exact, so that a node's photons follow
//      from its number. No planes: boxes around the photons, which enclose less. Four children to a node: two halvings
//      at once, since four boxes are tested as fast as one.
//   2. This file: build_range halves, stores a box, and calls itself for either half.
//   3. photon_map_median.c: what "halve" is. To find the median needs no sorting (quickselect).
//   4. photon_map_nearest.c: search_tree walks the tree for the k nearest, the nearest box first, with a radius that
//      shrinks. In place of a heap all that lie within it are collected, and cut down to k when the array is full. The
//      first radius is a guess (guess_limit).
// tests/unit/photons/test_photon_map.c compares the answers with a look at all photons, from none to 64 and for many.
#include "photons/photon_map_internal.h"
#include "base/parallel.h"

#include <stdlib.h>

enum {
    TASK_PHOTONS = 16384 // ranges longer than this are worth a task of their own
};

static const float FARTHEST = 1e18f; // m; its square is still far from overflowing

static Box bounds(const StoredPhoton *photons, size_t count)
{
    Box box = box_empty();
    for (size_t i = 0; i < count; i++)
        box_add_point(&box, photons[i].position);
    return box;
}

// Writes the box of range `index` of the 2^level ranges at `level` into its parent node.
static void store_box(PhotonMap *map, int level, size_t index, Box box)
{
    size_t ranges = (size_t)1 << level;
    size_t number = index + (level % 2 == 0 ? (ranges - 1) / 3 : 1 + (ranges - 2) / 3);
    size_t place = number - (size_t)map->first_child;
    MapNode *parent = &map->nodes[place / 4];
    for (int axis = 0; axis < 3; axis++) {
        parent->low[axis][place % 4] = vec3_component(box.low, axis);
        parent->high[axis][place % 4] = vec3_component(box.high, axis);
    }
}

// `values` has a place for each photon: each range uses its own.
static void build_range(PhotonMap *map, float *values, int level, size_t index)
{
    int halvings = map->depth - level;
    size_t begin = leaf_begin(map, index << halvings);
    size_t end = leaf_begin(map, (index + 1) << halvings);
    Box box = bounds(map->photons + begin, end - begin);
    if (level > 0 && halvings % 2 == 0)
        store_box(map, level, index, box);
    if (halvings == 0)
        return;
    size_t middle = leaf_begin(map, (2 * index + 1) << (halvings - 1));
    photon_map_halve(map->photons + begin, end - begin, box, middle - begin, values + begin);
    if (end - begin > TASK_PHOTONS) {
        OMP(omp task)
        build_range(map, values, level + 1, 2 * index);
    } else { // not `if` in the task's own line: it would cost something for each of a million ranges
        build_range(map, values, level + 1, 2 * index);
    }
    build_range(map, values, level + 1, 2 * index + 1);
}

static bool check_positions(const StoredPhoton *photons, size_t count, Error *error)
{
    for (size_t i = 0; i < count; i++) {
        Vec3 p = photons[i].position;
        if (!(fabsf(p.x) <= FARTHEST && fabsf(p.y) <= FARTHEST && fabsf(p.z) <= FARTHEST))
            return error_set(error, "photon %zu lies at (%g, %g, %g); coordinates must be finite and at most %g m", i,
                             (double)p.x, (double)p.y, (double)p.z, (double)FARTHEST);
    }
    return true;
}

static void set_shape(PhotonMap *map, size_t count)
{
    map->count = count;
    while (count > (size_t)LEAF_PHOTONS << map->depth)
        map->depth++;
    size_t leaves = (size_t)1 << map->depth;
    map->first_child = map->depth % 2 == 0 ? 1 : -1;
    map->node_count = map->depth % 2 == 0 ? (leaves - 1) / 3 : 1 + (leaves - 2) / 3;
}

static bool build_tree(PhotonMap *map, Error *error)
{
    if (!check_positions(map->photons, map->count, error))
        return false;
    if (map->count == 0)
        return true;
    float *values = malloc(map->count * sizeof *values);
    map->nodes = malloc((map->node_count + 1) * sizeof *map->nodes);
    if (!values || !map->nodes) {
        free(values);
        return error_set(error, "no memory for the index of %zu photons", map->count);
    }
    for (size_t i = 0; i < 12 * map->node_count; i++) { // all boxes empty
        map->nodes[i / 12].low[i / 4 % 3][i % 4] = INFINITY;
        map->nodes[i / 12].high[i / 4 % 3][i % 4] = -INFINITY;
    }
    OMP(omp parallel if (map->count > TASK_PHOTONS))
    OMP(omp single)
    build_range(map, values, 0, 0);
    free(values);
    return true;
}

PhotonMap *photon_map_build(StoredPhoton *photons, size_t count, Error *error)
{
    PhotonMap *map = calloc(1, sizeof *map);
    if (!map) {
        free(photons);
        error_set(error, "no memory for a photon map");
        return NULL;
    }
    map->photons = photons;
    set_shape(map, count);
    if (!build_tree(map, error)) {
        photon_map_free(map);
        return NULL;
    }
    return map;
}

size_t photon_map_count(const PhotonMap *map)
{
    return map->count;
}

const StoredPhoton *photon_map_photons(const PhotonMap *map)
{
    return map->photons;
}

size_t photon_map_bytes(const PhotonMap *map)
{
    return sizeof *map + map->count * sizeof *map->photons + map->node_count * sizeof *map->nodes;
}

void photon_map_free(PhotonMap *map)
{
    if (!map)
        return;
    free(map->photons);
    free(map->nodes);
    free(map);
}
