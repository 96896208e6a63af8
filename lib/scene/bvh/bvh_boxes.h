// A ray against the boxes of a node's children, all at once; for bvh_traverse.c only.
#pragma once

#include "scene/bvh/bvh_internal.h"

// Rounding moves the ends of the interval in which a ray is inside a box by a few units in the last place (Ize 2013). So a
// ray enters by so many earlier. The bits of floats that are not negative, taken for whole numbers, are in the floats'
// order, and quicker to reckon with.
#define BOX_SLACK 17

// A ray prepared for the boxes.
typedef struct {
    Lanes origin, inverse;
    float t_min;
    unsigned near[3]; // rows of Node.bounds where the ray enters a box; it leaves it at that row's neighbour
} BoxRay;

// Along an axis on which a ray hardly moves; its products with lengths are finite.
#define STEEPEST 1e18f

static inline BoxRay box_ray(const Ray *ray, float t_min)
{
    Float4 origin = {ray->origin.x, ray->origin.y, ray->origin.z, 0.0f};
    Float4 inverse = 1.0f / (Float4){ray->direction.x, ray->direction.y, ray->direction.z, 1.0f};
    inverse = float4_max(float4_min(inverse, float4_all(STEEPEST)), float4_all(-STEEPEST));
    float least = bits_float(BOX_SLACK);
    BoxRay r = {lanes_fours(&origin), lanes_fours(&inverse), t_min > least ? t_min : least, {0}};
    unsigned backwards = int4_bits(inverse < float4_all(0.0f));
    for (unsigned axis = 0; axis < 3; axis++)
        r.near[axis] = 2 * axis + (backwards >> axis & 1);
    return r;
}

// Which children does the ray meet before t_max, and where does it enter them?
static inline unsigned node_hits(const Node *node, const BoxRay *ray, float t_max, float enter[WIDTH])
{
    Lanes low = lanes_fours(node);
    Lanes start = (low - ray->origin) * ray->inverse;
    Lanes step = (Lanes)((LanesMask)low << 23) * ray->inverse;
    const Lanes from[3] = {lanes_pick(start, 0), lanes_pick(start, 1), lanes_pick(start, 2)};
    const Lanes by[3] = {lanes_pick(step, 0), lanes_pick(step, 1), lanes_pick(step, 2)};
    unsigned missed = 0;
    for (int lane = 0; lane < WIDTH; lane += LANES) {
        Lanes near = lanes_all(ray->t_min);
        Lanes far = lanes_all(t_max);
        for (int axis = 0; axis < 3; axis++) {
            const uint8_t *in = &node->bounds[ray->near[axis]][lane], *out = &node->bounds[ray->near[axis] ^ 1][lane];
            near = lanes_max(lanes_fma(lanes_bytes(in), by[axis], from[axis]), near);
            far = lanes_min(lanes_fma(lanes_bytes(out), by[axis], from[axis]), far);
        }
        LanesMask first = (LanesMask)near - BOX_SLACK;
        memcpy(&enter[lane], &first, sizeof first);
        missed |= lanes_bits(first > (LanesMask)far) << lane;
    }
    return ~missed & ((2u << node->last_child) - 1);
}
