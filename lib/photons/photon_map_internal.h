// How the photon map lies in memory. For the photon map's own files and the curious; photon_map.c has a reading order.
//
// Every split halves its photons exactly, so a node's range of the photon array follows from its place in the tree: of
// 2^depth leaves, leaf i holds the photons from count·i / 2^depth on. Nodes keep tight boxes in place of splitting
// planes: photons lie on surfaces, and a tight box is much smaller than its cell.
#pragma once

#include "math/ray.h"
#include "photons/photon_map.h"

#include <stdint.h>
#include <string.h>

enum {
    LEAF_PHOTONS = 16,  // at most, in a leaf; more than half of it if there is more than one leaf
    STACK_CAPACITY = 96 // a walk leaves at most three children waiting on each of 32 levels
};

// The boxes around four children's photons. An empty box (low = ∞, high = −∞) is infinitely far from everything.
typedef struct {
    float low[3][4], high[3][4]; // x, y, z
} MapNode;

// Nodes are numbered level by level from the root, 0, and leaves go on where nodes end. Child c of node i is
// 4·i + first_child + c. When depth is odd, the root has two children only, in its last two places, and
// first_child is −1; otherwise it is 1.
struct PhotonMap {
    StoredPhoton *photons;
    size_t count;
    MapNode *nodes;
    size_t node_count;
    int depth; // halvings from all photons to a leaf
    int first_child;
};

// Where leaf number `leaf` begins in the photon array, which is where leaf − 1 ends.
static inline size_t leaf_begin(const PhotonMap *map, size_t leaf)
{
    return (size_t)(((uint64_t)map->count * leaf) >> map->depth);
}

static inline size_t child_number(const PhotonMap *map, size_t number, size_t child)
{
    return 4 * number + (size_t)map->first_child + child;
}

// How far a number is outside [low, high]; 0 inside.
static inline float outside(float low, float value, float high)
{
    float below = low - value;
    float above = value - high;
    float most = below > above ? below : above;
    return most > 0.0f ? most : 0.0f;
}

// Squared distances from a point to a node's four boxes. The loop is written for the compiler to do as one.
static inline void node_distances(const MapNode *node, Vec3 point, float distance2[4])
{
    for (int c = 0; c < 4; c++) {
        float dx = outside(node->low[0][c], point.x, node->high[0][c]);
        float dy = outside(node->low[1][c], point.y, node->high[1][c]);
        float dz = outside(node->low[2][c], point.z, node->high[2][c]);
        distance2[c] = dx * dx + dy * dy + dz * dz;
    }
}

// Swaps two structs of `size` bytes (a constant, at most 32; they may be the same) as blocks. Swapped as structs,
// compilers write them field by field, and a wide load soon after waits for all the narrow stores: twice as slow.
static inline void swap_bytes(void *a, void *b, size_t size)
{
    unsigned char held_a[32];
    unsigned char held_b[32];
    memcpy(held_a, a, size);
    memcpy(held_b, b, size);
    memcpy(a, held_b, size);
    memcpy(b, held_a, size);
}

// Reorders the photons, which lie in `box`, so that none of the first `rank` has a larger coordinate along
// the box's longest side than any of the others. `values`: scratch for one float per photon.
void photon_map_halve(StoredPhoton *photons, size_t count, Box box, size_t rank, float *values);
