// Rays through the hierarchy. Of a node's children those nearest to the ray's origin are looked at first;
// whatever begins behind the closest hit so far is skipped.
#include "scene/bvh/bvh_boxes.h"
#include "scene/bvh/bvh_packets.h"

// The builder limits the depth: see DEPTH_LIMIT there.
#define STACK_SIZE (96 * (WIDTH - 1))

#define NOINLINE __attribute__((noinline)) // keeps registers for what surrounds it

// The distance at which the ray enters a child, which is no less than 0, so that its bits are in the order of their values;
// then the child.
typedef uint64_t Entry;

// Tests all packets of a tree that is nothing else.
static INLINE void all_closest(const Bvh *bvh, const Tree *tree, const PacketRay *ray, LaneHits *best)
{
    for (uint32_t i = 0; i < tree->packet_count; i++)
        if (tree == &bvh->flats)
            flats_closest((const FlatPacket *)tree->memory + i, ray, best);
        else
            spheres_closest((const SpherePacket *)tree->memory + i, ray, best);
}

// Is there a closer hit? At the same distance the primitive with the higher number counts as closer, so that it does not matter
// in which order a tree is searched. Not inlined: within the loop of the traversal, too few registers are left for it.
static NOINLINE bool leaf_closest(const Bvh *bvh, const Tree *tree, uint32_t leaf, const PacketRay *ray, BvhHit *hit)
{
    LaneHits at = {.id = int4_all(0)};
    Int4 met;
    if (tree == &bvh->flats) {
        met = flats_met(tree_at(tree, leaf), ray, hit->t, &at);
    } else {
        met = spheres_hit(tree_at(tree, leaf), ray, &at.t);
        at.id = int4_load(((const SpherePacket *)tree_at(tree, leaf))->id);
    }
    bool found = false;
    for (unsigned lanes = int4_bits(met); lanes; lanes &= lanes - 1) {
        int lane = __builtin_ctz(lanes);
        BvhHit one = {at.t[lane], at.u[lane], at.v[lane], (uint32_t)at.id[lane]};
        if (one.t < hit->t || (one.t == hit->t && one.primitive > hit->primitive)) {
            *hit = one;
            found = true;
        }
    }
    return found;
}

// Large trees do not fit into the caches, and waiting for memory takes most of the time. So a node's children that are nodes
// are asked for before it is known which of them are hit, up to so many,
#define PREFETCHED 6

static inline void prefetch_nodes(const Tree *tree, const Node *node)
{
    const char *end = tree_at(tree, node->children * LINE_PLACES);
    for (int i = 1; i <= PREFETCHED; i++)
        __builtin_prefetch(end - i * CACHE_LINE);
}

// and packets, which are larger, when they are.
static inline void prefetch(const Tree *tree, uint32_t child)
{
    const char *place = tree_at(tree, child);
    __builtin_prefetch(place);
    if (child & LEAF) {
        __builtin_prefetch(place + CACHE_LINE);
        __builtin_prefetch(place + 2 * CACHE_LINE);
    }
}

// Returns the nearest of the children that were hit, and puts the others on the stack, nearer ones above.
static inline uint32_t descend(const Tree *tree, const Node *node, unsigned hits, const float enter[WIDTH], Entry **top)
{
    uint32_t lane = (uint32_t)__builtin_ctz(hits);
    hits &= hits - 1;
    // Most often one node: what is guessed need not wait for the table.
    if (!hits && __builtin_expect(lane < node->node_count, 1))
        return (node->children + lane - node->node_count) * LINE_PLACES;
    uint32_t first = node_child(tree, node, lane);
    if (!hits)
        return first;
    Entry nearest = (Entry)float_bits(enter[lane]) << 32 | first;
    Entry *bottom = *top;
    for (; hits; hits &= hits - 1) {
        lane = (uint32_t)__builtin_ctz(hits);
        uint32_t child = node_child(tree, node, lane);
        prefetch(tree, child);
        Entry entry = (Entry)float_bits(enter[lane]) << 32 | child;
        Entry further = entry > nearest ? entry : nearest;
        nearest = entry > nearest ? nearest : entry;
        Entry *at = (*top)++;
        for (; at > bottom && at[-1] < further; at--)
            *at = at[-1];
        *at = further;
    }
    return (uint32_t)nearest;
}

static inline bool tree_closest(const Bvh *bvh, const Tree *tree, const Ray *ray, const PacketRay *packet_ray,
                                BvhHit *hit)
{
    bool found = false;
    if (tree->root & LEAF) {
        for (uint32_t i = 0; i < tree->packet_count; i++)
            found |= leaf_closest(bvh, tree, i * tree->packet_places, packet_ray, hit);
        return found;
    }
    BoxRay boxes = box_ray(ray, packet_ray->t_min[0]);
    Entry stack[STACK_SIZE];
    Entry *top = stack;
    uint32_t child = tree->root;
    for (;;) {
        unsigned hits = 1;
        while (!(child & LEAF)) {
            float enter[WIDTH];
            const Node *node = tree_at(tree, child);
            prefetch_nodes(tree, node);
            hits = node_hits(node, &boxes, hit->t, enter);
            if (!hits)
                break;
            child = descend(tree, node, hits, enter, &top);
        }
        if (hits)
            found |= leaf_closest(bvh, tree, child, packet_ray, hit);
        do {
            if (top == stack)
                return found;
            top--;
        } while (*top >> 32 >= float_bits(hit->t));
        child = (uint32_t)*top;
    }
}

// Of a small scene, whose two trees are a leaf each: tests all of it, without boxes.
static NOINLINE bool small_closest(const Bvh *bvh, const Ray *ray, float t_min, float t_max, BvhHit *hit)
{
    PacketRay packets = packet_ray(ray, t_min, NO_PRIMITIVE);
    LaneHits best = {.t = float4_all(t_max)};
    all_closest(bvh, &bvh->spheres, &packets, &best);
    all_closest(bvh, &bvh->flats, &packets, &best);
    hit->t = t_max;
    return lanes_reduce(&best, hit);
}

static NOINLINE bool large_closest(const Bvh *bvh, const Ray *ray, float t_min, float t_max, BvhHit *hit)
{
    PacketRay packets = packet_ray(ray, t_min, NO_PRIMITIVE);
    *hit = (BvhHit){.t = t_max, .primitive = NO_PRIMITIVE};
    bool found = tree_closest(bvh, &bvh->spheres, ray, &packets, hit);
    found |= tree_closest(bvh, &bvh->flats, ray, &packets, hit);
    return found;
}

// Minimum and maximum of NaN are whatever comes second, so a NaN would seem to hit every box, even those that are not
// there. A student's step may well send one.
static inline bool ray_is_sound(const Ray *ray)
{
    float length2 = vec3_dot(ray->direction, ray->direction);
    float reach = fabsf(ray->origin.x) + fabsf(ray->origin.y) + fabsf(ray->origin.z);
    return length2 > 0.0f && length2 < INFINITY && reach < INFINITY;
}

bool bvh_closest(const Bvh *bvh, const Ray *ray, float t_min, float t_max, BvhHit *hit)
{
    if (!ray_is_sound(ray))
        return false;
    bool small = bvh->flats.root & bvh->spheres.root & LEAF;
    return (small ? small_closest : large_closest)(bvh, ray, t_min, t_max, hit);
}

static inline Int4 leaf_occludes(const Bvh *bvh, const Tree *tree, uint32_t leaf, const PacketRay *ray, float t_max)
{
    return tree == &bvh->flats ? flats_occlude(tree_at(tree, leaf), ray, float4_all(t_max))
                               : spheres_occlude(tree_at(tree, leaf), ray, float4_all(t_max));
}

static inline bool tree_occluded(const Bvh *bvh, const Tree *tree, const Ray *ray, const PacketRay *packet_ray,
                                 float t_max)
{
    if (tree->root & LEAF) {
        Int4 found = int4_all(0);
        for (uint32_t packet = 0; packet < tree->packet_count; packet++)
            found |= leaf_occludes(bvh, tree, packet * tree->packet_places, packet_ray, t_max);
        return int4_bits(found) != 0;
    }
    BoxRay boxes = box_ray(ray, packet_ray->t_min[0]);
    uint32_t stack[STACK_SIZE];
    uint32_t *top = stack;
    *top++ = tree->root;
    while (top > stack) {
        uint32_t child = *--top;
        while (!(child & LEAF)) {
            float enter[WIDTH];
            const Node *node = tree_at(tree, child);
            prefetch_nodes(tree, node);
            unsigned hits = node_hits(node, &boxes, t_max, enter);
            if (!hits)
                break;
            child = node_child(tree, node, (uint32_t)__builtin_ctz(hits));
            for (hits &= hits - 1; hits; hits &= hits - 1) {
                *top = node_child(tree, node, (uint32_t)__builtin_ctz(hits));
                prefetch(tree, *top++);
            }
        }
        if ((child & LEAF) && int4_bits(leaf_occludes(bvh, tree, child, packet_ray, t_max)))
            return true;
    }
    return false;
}

bool bvh_occluded(const Bvh *bvh, const Ray *ray, float t_min, float t_max, uint32_t except)
{
    if (!ray_is_sound(ray))
        return false;
    PacketRay packets = packet_ray(ray, t_min, except);
    return tree_occluded(bvh, &bvh->spheres, ray, &packets, t_max) ||
           tree_occluded(bvh, &bvh->flats, ray, &packets, t_max);
}
