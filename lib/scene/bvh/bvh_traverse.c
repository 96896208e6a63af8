// Rays through the hierarchy. Of a node's children those nearest to the ray's origin are looked at first;
// whatever begins behind the closest hit so far is skipped.
#include "scene/bvh/bvh_packets.h"

// The builder limits the depth: see DEPTH_LIMIT there.
#define STACK_SIZE (96 * (WIDTH - 1))

// Rounding moves the ends of the interval in which a ray is inside a box by up to 3 units in the last place
// (Ize 2013).
#define BOX_SLACK (1.0f - 5e-7f)

#define NOINLINE __attribute__((noinline)) // keeps registers for what surrounds it

typedef struct {
    float t; // where the ray enters it
    uint32_t child;
} Entry;

// A ray prepared for the boxes.
typedef struct {
    Lanes origin[3], inverse[3];
    Lanes t_min;
    int near[3], far[3]; // rows of Node.bounds where the ray enters and leaves a box
} BoxRay;

static inline BoxRay box_ray(const Ray *ray, float t_min)
{
    BoxRay r;
    for (int axis = 0; axis < 3; axis++) {
        float inverse = 1.0f / vec3_component(ray->direction, axis); // ±∞ is fine
        r.origin[axis] = lanes_all(vec3_component(ray->origin, axis));
        r.inverse[axis] = lanes_all(inverse);
        r.near[axis] = inverse < 0.0f ? axis + 3 : axis;
        r.far[axis] = inverse < 0.0f ? axis : axis + 3;
    }
    r.t_min = lanes_all(t_min);
    return r;
}

static inline Lanes lanes_load(const float *from)
{
    Lanes lanes;
    memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

// Which children does the ray meet before t_max, and where does it enter them? Along an axis on which the ray does not
// move, `inverse` is infinite: a slab that the origin lies in gives −∞…∞, one on whose face it lies 0·∞, which is NaN;
// lanes_min and lanes_max then return their second operand.
static inline unsigned node_hits(const Node *node, const BoxRay *ray, float t_max, float enter[WIDTH])
{
    unsigned hits = 0;
    for (int lane = 0; lane < WIDTH; lane += LANES) {
        Lanes near = ray->t_min;
        Lanes far = lanes_all(t_max);
        for (int axis = 0; axis < 3; axis++) {
            Lanes in = (lanes_load(&node->bounds[ray->near[axis]][lane]) - ray->origin[axis]) * ray->inverse[axis];
            Lanes out = (lanes_load(&node->bounds[ray->far[axis]][lane]) - ray->origin[axis]) * ray->inverse[axis];
            near = lanes_max(in, near);
            far = lanes_min(out, far);
        }
        near *= lanes_all(BOX_SLACK);
        memcpy(&enter[lane], &near, sizeof near);
        hits |= lanes_bits(near <= far) << lane;
    }
    return hits;
}

static inline uint32_t leaf_end(uint32_t leaf)
{
    return (leaf & FIRST_PACKET) + (leaf >> 28 & 7u) + 1;
}

static INLINE void leaf_closest(const Bvh *bvh, const Tree *tree, uint32_t leaf, const PacketRay *ray,
                                Expected expected, LaneHits *best)
{
    uint32_t end = leaf_end(leaf);
    for (uint32_t packet = leaf & FIRST_PACKET; packet < end; packet++)
        if (tree == &bvh->flats)
            flats_closest((const FlatPacket *)tree->packets + packet, ray, expected, best);
        else
            spheres_closest((const SpherePacket *)tree->packets + packet, ray, best);
}

// Not inlined: within the loop of the traversal, too few registers are left for it.
static NOINLINE void leaf_of_many(const Bvh *bvh, const Tree *tree, uint32_t leaf, const PacketRay *ray, LaneHits *best)
{
    leaf_closest(bvh, tree, leaf, ray, MOSTLY_MISSED, best);
}

// Asks for a child's memory early: a large tree does not fit into the caches, and waiting for it takes most
// of the time.
static inline void prefetch(const Tree *tree, uint32_t child)
{
    const char *base = child & LEAF ? tree->packets : (const char *)tree->nodes;
    size_t size = child & LEAF ? tree->packet_size : sizeof(Node);
    const char *place = base + (child & FIRST_PACKET) * size;
    __builtin_prefetch(place);
    __builtin_prefetch(place + 64);
    __builtin_prefetch(place + 128);
    __builtin_prefetch(place + size - 1);
}

// Returns the nearest of the children that were hit, and puts the others on the stack, nearer ones above.
static inline uint32_t descend(const Tree *tree, const Node *node, unsigned hits, const float enter[WIDTH], Entry **top)
{
    int lane = __builtin_ctz(hits);
    Entry nearest = {enter[lane], node->child[lane]};
    Entry *bottom = *top;
    for (hits &= hits - 1; hits; hits &= hits - 1) {
        lane = __builtin_ctz(hits);
        Entry entry = {enter[lane], node->child[lane]};
        prefetch(tree, entry.child);
        if (entry.t < nearest.t) {
            Entry other = nearest;
            nearest = entry;
            entry = other;
        }
        Entry *at = (*top)++;
        for (; at > bottom && at[-1].t < entry.t; at--)
            *at = at[-1];
        *at = entry;
    }
    return nearest.child;
}

static inline bool tree_closest(const Bvh *bvh, const Tree *tree, const Ray *ray, const PacketRay *packet_ray,
                                BvhHit *hit)
{
    bool found = false;
    if (tree->root == NO_CHILD)
        return false;
    BoxRay boxes = box_ray(ray, packet_ray->t_min[0]);
    Entry stack[STACK_SIZE];
    Entry *top = stack;
    uint32_t child = tree->root;
    for (;;) {
        unsigned hits = 1;
        while (!(child & LEAF)) {
            float enter[WIDTH];
            const Node *node = &tree->nodes[child];
            hits = node_hits(node, &boxes, hit->t, enter);
            if (!hits)
                break;
            child = descend(tree, node, hits, enter, &top);
        }
        if (hits) {
            LaneHits best = {.t = float4_all(hit->t)};
            leaf_of_many(bvh, tree, child, packet_ray, &best);
            found |= lanes_reduce(&best, hit);
        }
        do {
            if (top == stack)
                return found;
            top--;
        } while (top->t >= hit->t);
        child = top->child;
    }
}

// Of a small scene, whose two trees are a leaf each: tests all of it, without boxes.
static NOINLINE bool small_closest(const Bvh *bvh, const Ray *ray, float t_min, float t_max, BvhHit *hit)
{
    PacketRay packets = packet_ray(ray, t_min, NO_PRIMITIVE);
    LaneHits best = {.t = float4_all(t_max)};
    if (bvh->spheres.root != NO_CHILD)
        leaf_closest(bvh, &bvh->spheres, bvh->spheres.root, &packets, HIT_AS_OFTEN, &best);
    if (bvh->flats.root != NO_CHILD)
        leaf_closest(bvh, &bvh->flats, bvh->flats.root, &packets, HIT_AS_OFTEN, &best);
    hit->t = t_max;
    return lanes_reduce(&best, hit);
}

static NOINLINE bool large_closest(const Bvh *bvh, const Ray *ray, float t_min, float t_max, BvhHit *hit)
{
    PacketRay packets = packet_ray(ray, t_min, NO_PRIMITIVE);
    hit->t = t_max;
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

static inline bool leaf_occluded(const Bvh *bvh, const Tree *tree, uint32_t leaf, const PacketRay *ray, float t_max)
{
    uint32_t end = leaf_end(leaf);
    Int4 found = int4_all(0);
    for (uint32_t packet = leaf & FIRST_PACKET; packet < end; packet++)
        found |= tree == &bvh->flats
                     ? flats_occlude((const FlatPacket *)tree->packets + packet, ray, float4_all(t_max))
                     : spheres_occlude((const SpherePacket *)tree->packets + packet, ray, float4_all(t_max));
    return int4_bits(found) != 0;
}

static inline bool tree_occluded(const Bvh *bvh, const Tree *tree, const Ray *ray, const PacketRay *packet_ray,
                                 float t_max)
{
    if (tree->root & LEAF)
        return tree->root != NO_CHILD && leaf_occluded(bvh, tree, tree->root, packet_ray, t_max);
    BoxRay boxes = box_ray(ray, packet_ray->t_min[0]);
    uint32_t stack[STACK_SIZE];
    uint32_t *top = stack;
    *top++ = tree->root;
    while (top > stack) {
        uint32_t child = *--top;
        while (!(child & LEAF)) {
            float enter[WIDTH];
            const Node *node = &tree->nodes[child];
            unsigned hits = node_hits(node, &boxes, t_max, enter);
            if (!hits)
                break;
            child = node->child[__builtin_ctz(hits)];
            for (hits &= hits - 1; hits; hits &= hits - 1) {
                *top = node->child[__builtin_ctz(hits)];
                prefetch(tree, *top++);
            }
        }
        if ((child & LEAF) && leaf_occluded(bvh, tree, child, packet_ray, t_max))
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
