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
//   2. photon_map_build.c: build_range halves, stores a box, and calls itself for either half.
//   3. photon_map_median.c: what "halve" is. To find the median needs no sorting (quickselect).
//   4. This file: photon_map_visit walks the tree with a fixed radius. It is the search without its difficulties.
//   5. photon_map_nearest.c: search_tree is the same walk for the k nearest, the nearest box first, with a radius that
//      shrinks. In place of a heap all that lie within it are collected, and cut down to k when the array is full. The
//      first radius is a guess (guess_limit).
// tests/unit/photons/test_photon_map.c compares the answers with a look at all photons, from none to 64 and for many.
#include "photons/photon_map_internal.h"

#include <stdlib.h>

// A run of leaves that follow one another in the photon array, gathered for one call of the visitor.
typedef struct {
    const PhotonMap *map;
    PhotonVisitor visit;
    void *user;
    size_t begin, end;
} Run;

static void run_visit(Run *run)
{
    if (run->end > run->begin)
        run->visit(run->map->photons + run->begin, run->end - run->begin, run->user);
}

static void run_add_leaf(Run *run, size_t leaf)
{
    size_t begin = leaf_begin(run->map, leaf);
    if (begin != run->end) {
        run_visit(run);
        run->begin = begin;
    }
    run->end = leaf_begin(run->map, leaf + 1);
}

void photon_map_visit(const PhotonMap *map, Vec3 point, float radius, PhotonVisitor visit, void *user)
{
    if (map->count == 0)
        return;
    Run run = {.map = map, .visit = visit, .user = user};
    size_t stack[STACK_CAPACITY];
    stack[0] = 0;
    size_t waiting = 1;
    while (waiting > 0) {
        size_t number = stack[--waiting];
        if (number >= map->node_count) {
            run_add_leaf(&run, number - map->node_count);
            continue;
        }
        float distance2[4];
        node_distances(&map->nodes[number], point, distance2);
        for (size_t c = 4; c-- > 0;) { // backwards, so that leaves come off the stack in order and make long runs
            stack[waiting] = child_number(map, number, c);
            waiting += distance2[c] < radius * radius;
        }
    }
    run_visit(&run);
}

typedef struct {
    Vec3 point;
    float radius2;
    NearPhoton *near;
    size_t capacity, found;
} Within;

static void within_add(const StoredPhoton *run, size_t count, void *user)
{
    Within *within = user;
    if (within->found + count <= within->capacity) {
        within->found += collect(run, count, within->point, within->radius2, within->near + within->found);
        return;
    }
    for (size_t i = 0; i < count; i++) {
        NearPhoton entry;
        if (collect(&run[i], 1, within->point, within->radius2, &entry) == 0)
            continue;
        if (within->found < within->capacity)
            within->near[within->found] = entry;
        within->found++;
    }
}

size_t photon_map_within(const PhotonMap *map, Vec3 point, float radius, NearPhoton *near, size_t capacity)
{
    Within within = {point, radius * radius, near, capacity, 0};
    photon_map_visit(map, point, radius, within_add, &within);
    return within.found;
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
