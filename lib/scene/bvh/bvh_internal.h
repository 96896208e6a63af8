// Inside of the bounding volume hierarchy; for bvh*.c only.
//
// Two trees stand side by side, one over the flats and one over the spheres. A node has up to eight children,
// whose boxes lie lane by lane so that a few instructions test them all. A leaf is a run of packets of four
// primitives, laid out the same way. A small scene is one leaf and no node at all.
#ifndef PHOTONLAB_SCENE_BVH_INTERNAL_H
#define PHOTONLAB_SCENE_BVH_INTERNAL_H

#include "base/parallel.h"
#include "scene/bvh/bvh.h"
#include "scene/bvh/bvh_lanes.h"

#define WIDTH      8    // children of a node; a multiple of LANES
#define PACKET     4    // primitives in a packet
#define TASK_COUNT 4096 // a subtree with fewer references is built without waking another thread

// Flats are tested as if their edges were this much longer (relative), so that no ray slips between two that
// share an edge. With 1e-6, a few of a million rays still do on a mesh of a million triangles.
#define EDGE_SLACK 1e-5f

// Where a child is: the index of a node, or LEAF | (packets − 1) << 28 | index of the first packet.
#define LEAF             0x80000000u
#define FIRST_PACKET     0x0fffffffu
#define LEAF_MAX_PACKETS 8
#define NO_CHILD         UINT32_MAX

#define SMALL_SCENE 16 // up to so many primitives are tested without any boxes

typedef struct {
    float bounds[6][WIDTH]; // low x, y, z, high x, y, z of each child; an unused one has low = +∞, high = −∞
    uint32_t child[WIDTH];
} Node;

#define TRIANGLE 0x80000000u // in FlatPacket.id: a triangle, else a parallelogram

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
    Node *nodes;
    uint32_t root; // NO_CHILD: the tree is empty
    uint32_t node_count, packet_count;
    char *packets; // FlatPackets or SpherePackets
    size_t packet_size;
} Tree;

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

// Which references a packet takes.
typedef struct {
    uint32_t first, count;
} Run;

#define INNER 0

// A node of the binary tree. A subtree over n references takes 2n−1 places: its root first, then its left
// child, and the right child after all that the left one may need. Which thread builds it makes no
// difference.
typedef struct {
    float low[3];
    uint32_t first; // leaf: its first reference; else: index of the right child
    float high[3];
    uint32_t count; // INNER or the leaf's number of references
} Split;

static inline uint32_t packets_of(uint32_t count)
{
    return (count + PACKET - 1) / PACKET;
}

// Memory to free() again, aligned for nodes; in large pages where it is large and the system has them: a ray
// touches places all over the tree, and looking up where each page lies costs as much as reading it.
void *bvh_allocate(size_t bytes);

// Builds the tree over `count` references, which it reorders; packet p of the tree takes the references in
// (*runs)[p]. The caller frees *runs and tree->nodes, also when it fails: false when memory is short.
bool bvh_build_tree(Reference *references, size_t count, Tree *tree, Run **runs);

// What bvh_build_tree ends with: makes nodes of up to eight children from the binary tree.
bool bvh_collapse(const Split *splits, size_t count, Tree *tree, Run **runs);

#endif
