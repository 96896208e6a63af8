// Building the photon map: halve the photons at the median of their box's longest side, again and again.
#include "photons/photon_map_internal.h"

#include <stdlib.h>

enum {
    TASK_PHOTONS = 16384 // ranges longer than this are worth a task of their own
};

static const float FARTHEST = 1e18f; // m; its square is still far from overflowing

// What the recursion works on. `values` has a place for each photon: each range uses its own.
typedef struct {
    PhotonMap *map;
    float *values;
} Builder;

static Box bounds(const StoredPhoton *photons, size_t count)
{
    Box box = {photons[0].position, photons[0].position};
    for (size_t i = 1; i < count; i++) {
        Vec3 p = photons[i].position;
        box.low.x = p.x < box.low.x ? p.x : box.low.x;
        box.low.y = p.y < box.low.y ? p.y : box.low.y;
        box.low.z = p.z < box.low.z ? p.z : box.low.z;
        box.high.x = p.x > box.high.x ? p.x : box.high.x;
        box.high.y = p.y > box.high.y ? p.y : box.high.y;
        box.high.z = p.z > box.high.z ? p.z : box.high.z;
    }
    return box;
}

// Writes the box of range `index` of the 2^level ranges at `level` into its parent node.
static void store_box(PhotonMap *map, int level, size_t index, Box box)
{
    size_t ranges = (size_t)1 << level;
    size_t number = index + (level % 2 == 0 ? (ranges - 1) / 3 : 1 + (ranges - 2) / 3);
    size_t place = number - (size_t)map->first_child;
    MapNode *parent = &map->nodes[place / 4];
    size_t child = place % 4;
    parent->low_x[child] = box.low.x;
    parent->low_y[child] = box.low.y;
    parent->low_z[child] = box.low.z;
    parent->high_x[child] = box.high.x;
    parent->high_y[child] = box.high.y;
    parent->high_z[child] = box.high.z;
}

static void build_range(const Builder *builder, int level, size_t index)
{
    PhotonMap *map = builder->map;
    int halvings = map->depth - level;
    size_t begin = leaf_begin(map, index << halvings);
    size_t end = leaf_begin(map, (index + 1) << halvings);
    Box box = bounds(map->photons + begin, end - begin);
    if (level > 0 && halvings % 2 == 0)
        store_box(map, level, index, box);
    if (halvings == 0)
        return;
    size_t middle = leaf_begin(map, (2 * index + 1) << (halvings - 1));
    photon_map_halve(map->photons + begin, end - begin, box, middle - begin, builder->values + begin);
    if (end - begin > TASK_PHOTONS) {
#ifdef _OPENMP
#pragma omp task
#endif
        build_range(builder, level + 1, 2 * index);
    } else {
        build_range(builder, level + 1, 2 * index);
    }
    build_range(builder, level + 1, 2 * index + 1);
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

// Allocates the nodes, all their boxes empty.
static bool allocate_nodes(PhotonMap *map)
{
    map->nodes = malloc((map->node_count + 1) * sizeof *map->nodes);
    if (!map->nodes)
        return false;
    for (size_t i = 0; i < map->node_count; i++)
        for (int c = 0; c < 4; c++) {
            MapNode *node = &map->nodes[i];
            node->low_x[c] = node->low_y[c] = node->low_z[c] = INFINITY;
            node->high_x[c] = node->high_y[c] = node->high_z[c] = -INFINITY;
        }
    return true;
}

static bool build_tree(PhotonMap *map, Error *error)
{
    if (!check_positions(map->photons, map->count, error))
        return false;
    if (map->count == 0)
        return true;
    float *values = malloc(map->count * sizeof *values);
    if (!values || !allocate_nodes(map)) {
        free(values);
        return error_set(error, "no memory for the index of %zu photons", map->count);
    }
    Builder builder = {map, values};
#ifdef _OPENMP
#pragma omp parallel if (map->count > TASK_PHOTONS)
#pragma omp single
#endif
    build_range(&builder, 0, 0);
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
