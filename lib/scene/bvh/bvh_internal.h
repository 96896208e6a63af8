// Inside of the bounding volume hierarchy; for bvh*.c only.
//
// Two trees stand side by side, one over the flats and one over the spheres. A node has up to eight children, whose boxes lie
// lane by lane so that a few instructions test them all. A leaf is a packet of four primitives, laid out the same way. Rays wait
// for memory most of the time, so that a node is one line of the cache, its boxes rounded outwards to bytes (as in Ylitie, Karras
// & Laine 2017), and its children lie side by side. A small scene is a few packets and no node at all.
#pragma once

#include "base/array.h"
#include "base/parallel.h"
#include "scene/bvh/bvh.h"
#include "scene/bvh/bvh_lanes.h"

#define WIDTH      8    // children of a node; a multiple of LANES
#define PACKET     4    // primitives in a packet
#define TASK_COUNT 4096 // a subtree with fewer references is built without waking another thread

// Flats are tested as if their edges were this much longer (relative), so that no ray slips between two that
// share an edge. With 1e-6, a few of a million rays still do on a mesh of a million triangles.
#define EDGE_SLACK 1e-5f

// Where a child is: a place in the tree's memory, with LEAF if it is a packet.
#define LEAF        0x80000000u
#define NO_CHILD    UINT32_MAX
#define PLACE       16 // bytes
#define LINE_PLACES (CACHE_LINE / PLACE)

#define SMALL_SCENE 16 // up to so many primitives are tested without any boxes

// Its first children are nodes, which end at the line `children` of the tree's memory, the others packets, which begin there.
typedef struct {
    float low[3]; // where the children's boxes begin; its last nine bits are a step's exponent along that axis, too
    uint32_t children : 25, node_count : 4, last_child : 3;
    uint8_t bounds[6][WIDTH]; // low x, high x, low y, high y, low z, high z of each child in steps from `low`
} Node;

#define MOST_LINES (1u << 25)
#define TRIANGLE   0x80000000u // in FlatPacket.id: a triangle, else a parallelogram

// An unused lane has edges of length 0, which no ray hits.
typedef struct {
    float origin[3][PACKET], edge_u[3][PACKET], edge_v[3][PACKET];
    uint32_t id[PACKET]; // primitive number | TRIANGLE
} FlatPacket;

// An unused lane has squared radius −1.
typedef struct {
    float centre[3][PACKET], radius2[PACKET];
    uint32_t id[PACKET];
} SpherePacket;

typedef struct {
    char *memory;
    uint32_t root; // NO_CHILD: the tree is empty; LEAF: there are packets only
    uint32_t end;  // of the places in use
    uint32_t packet_count, packet_places;
    uint32_t offset[2 * WIDTH]; // places from `children` to WIDTH nodes before and WIDTH packets behind
} Tree;

static inline void *tree_at(const Tree *tree, uint32_t child)
{
    return tree->memory + (size_t)(child & ~LEAF) * PLACE;
}

static inline uint32_t node_child(const Tree *tree, const Node *node, uint32_t number)
{
    return node->children * LINE_PLACES + tree->offset[WIDTH + number - node->node_count];
}

struct Bvh {
    Tree flats, spheres;
    Box bounds;
};

// A primitive's box as the builder sees it. Its number travels in lane 3: the lower 16 bits in `low`, the upper ones
// in `high`, since a float holds 16 bits exactly.
typedef struct {
    Float4 low, high;
} Reference;

static inline uint32_t reference_id(const Reference *reference)
{
    return (uint32_t)reference->low[3] | (uint32_t)reference->high[3] << 16;
}

// All flats or all spheres.
typedef struct Shapes {
    const void *items;
    size_t count, first_id; // their numbers as primitives
    Box (*box)(const void *items, size_t i);
    void (*pack)(const struct Shapes *shapes, const Reference *references, uint32_t count, void *packet);
    size_t packet_size;
} Shapes;

#define INNER 0

// A node of the binary tree. A subtree over n references takes 2n−1 places: its root first, then its left child, and the right
// child after all that the left one may need. Which thread builds it makes no difference.
typedef struct {
    float low[3];
    uint32_t first; // leaf: its first reference; else: index of the right child
    float high[3];
    uint32_t count; // INNER or the leaf's number of references
    uint32_t packets;
    float cost[WIDTH - 1]; // [n − 1]: the area of all nodes below where it becomes n children of a node
} Split;

static inline uint32_t packets_of(uint32_t count)
{
    return (count + PACKET - 1) / PACKET;
}

// Builds the tree over the shapes' references, which it reorders. The caller frees tree->memory, also when it fails: false when
// memory is short.
bool bvh_build_tree(const Shapes *shapes, Reference *references, Tree *tree);

// What bvh_build_tree ends with: makes wide nodes of the binary tree, as its splits' costs say, and packets.
bool bvh_collapse(const Shapes *shapes, const Reference *references, const Split *splits, Tree *tree);

// Fills in what a split costs when both its children are known.
void bvh_plan(Split *splits, uint32_t node);
