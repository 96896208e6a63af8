// A ray against packets of four flats or four spheres at once; for bvh_traverse.c only.
#pragma once

#include "scene/bvh/bvh_internal.h"

#define INLINE inline __attribute__((always_inline)) // otherwise compilers pass the hits through memory, which is slow

// A ray prepared for the packets.
typedef struct {
    Float4 origin[3], direction[3];
    Int4 from, except;
    Float4 t_min;
} PacketRay;

static inline PacketRay packet_ray(const Ray *ray, float t_min, uint32_t except)
{
    return (PacketRay){
        .origin = {float4_all(ray->origin.x), float4_all(ray->origin.y), float4_all(ray->origin.z)},
        .direction = {float4_all(ray->direction.x), float4_all(ray->direction.y), float4_all(ray->direction.z)},
        .from = int4_all(ray->from),
        .except = int4_all(except),
        .t_min = float4_all(t_min),
    };
}

static inline Float4 dot4(const Float4 a[3], const Float4 b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void cross4(const Float4 a[3], const Float4 b[3], Float4 result[3])
{
    result[0] = a[1] * b[2] - a[2] * b[1];
    result[1] = a[2] * b[0] - a[0] * b[2];
    result[2] = a[0] * b[1] - a[1] * b[0];
}

static inline void load3(const float from[3][PACKET], Float4 lanes[3])
{
    for (int axis = 0; axis < 3; axis++)
        lanes[axis] = float4_load(from[axis]);
}

// A hit in each lane; where there are several packets, the closest so far.
typedef struct {
    Float4 t, u, v;
    Int4 id;
} LaneHits;

// Möller & Trumbore 1997, four at once, without their division: t, u and v are still to be divided by *determinant. Returns the
// flats that the line through the ray crosses.
static inline Int4 flats_crossed(const FlatPacket *packet, const PacketRay *ray, LaneHits *at, Float4 *determinant)
{
    Float4 to_origin[3], edge_u[3], edge_v[3], normal[3], moment[3];
    load3(packet->edge_u, edge_u);
    load3(packet->edge_v, edge_v);
    load3(packet->origin, to_origin);
    for (int axis = 0; axis < 3; axis++)
        to_origin[axis] -= ray->origin[axis];
    cross4(edge_u, edge_v, normal);
    cross4(to_origin, ray->direction, moment);

    const Int4 sign_bit = int4_all(0x80000000u);
    Float4 facing = dot4(normal, ray->direction);
    Int4 sign = (Int4)facing & sign_bit;
    Float4 size = (Float4)((Int4)facing ^ sign);
    Float4 t = (Float4)((Int4)dot4(normal, to_origin) ^ sign);
    Float4 u = (Float4)((Int4)dot4(edge_v, moment) ^ sign);
    Float4 v = (Float4)((Int4)dot4(edge_u, moment) ^ sign ^ sign_bit);

    // A triangle ends at u + v = 1, a parallelogram at u = 1; v never exceeds 1.
    Int4 id = int4_load(packet->id);
    Float4 u_end = u + (Float4)((Int4)v & (id >> 31));
    Float4 low = size * float4_all(-EDGE_SLACK);
    Float4 high = size * float4_all(1.0f + EDGE_SLACK);
    *at = (LaneHits){t, u, v, id & ~sign_bit};
    *determinant = size;
    return (float4_min(u, v) >= low) & (float4_max(u_end, v) <= high) & ~(at->id == ray->from);
}

// Four spheres at once, in the form of Haines, Günther & Akenine-Möller (Ray Tracing Gems, 2019, ch. 7),
// which stays exact for spheres that are small and far or huge and near. `t` is the smaller root beyond
// t_min.
static inline Int4 spheres_hit(const SpherePacket *packet, const PacketRay *ray, Float4 *t)
{
    Float4 centre[3], offset[3], closest[3];
    load3(packet->centre, centre);
    for (int axis = 0; axis < 3; axis++)
        offset[axis] = ray->origin[axis] - centre[axis];
    Float4 inverse_a = 1.0f / dot4(ray->direction, ray->direction);
    Float4 b = -dot4(offset, ray->direction);
    for (int axis = 0; axis < 3; axis++)
        closest[axis] = offset[axis] + b * inverse_a * ray->direction[axis];
    Float4 radius2 = float4_load(packet->radius2);
    Float4 discriminant = (radius2 - dot4(closest, closest)) * dot4(ray->direction, ray->direction);
    Float4 c = dot4(offset, offset) - radius2;

    // The sphere that the ray leaves: its origin lies on it, so that the roots are 0 and 2b/a.
    Int4 id = int4_load(packet->id);
    Int4 leaving = id == ray->from;
    discriminant = float4_select(leaving, b * b, discriminant);
    c = float4_select(leaving, float4_all(0.0f), c);

    Float4 root = float4_sqrt(float4_max(discriminant, float4_all(0.0f)));
    Float4 q = b + (Float4)((Int4)root | ((Int4)b & int4_all(0x80000000u)));
    Float4 one = c / q, other = q * inverse_a;
    Float4 first = float4_min(one, other), second = float4_max(one, other);
    *t = float4_select(first > ray->t_min, first, second);
    return (discriminant >= float4_all(0.0f)) & (*t > ray->t_min);
}

static inline void lanes_keep(LaneHits *best, Int4 closer, const LaneHits *at)
{
    best->t = float4_select(closer, at->t, best->t);
    best->u = float4_select(closer, at->u, best->u);
    best->v = float4_select(closer, at->v, best->v);
    best->id = (closer & at->id) | (~closer & best->id);
}

static inline void lanes_divide(LaneHits *at, Float4 determinant)
{
    Float4 scale = 1.0f / determinant;
    at->t *= scale;
    at->u *= scale;
    at->v *= scale;
}

static INLINE void flats_closest(const FlatPacket *packet, const PacketRay *ray, LaneHits *best)
{
    LaneHits at;
    Float4 determinant;
    Int4 crossed = flats_crossed(packet, ray, &at, &determinant);
    lanes_divide(&at, determinant);
    lanes_keep(best, crossed & (at.t > ray->t_min) & (at.t < best->t), &at);
}

static INLINE void spheres_closest(const SpherePacket *packet, const PacketRay *ray, LaneHits *best)
{
    LaneHits at = {.id = int4_load(packet->id)};
    Int4 hit = spheres_hit(packet, ray, &at.t);
    lanes_keep(best, hit & (at.t < best->t), &at);
}

// Which flats of a leaf does the ray meet up to t_max, and maybe a little further? Most are missed, and a test for that saves the
// division.
static INLINE Int4 flats_met(const FlatPacket *packet, const PacketRay *ray, float t_max, LaneHits *at)
{
    Float4 determinant;
    Int4 met = flats_crossed(packet, ray, at, &determinant);
    met &= (at->t > float4_all(0.0f)) & (at->t <= determinant * float4_all(t_max * (1.0f + 1e-6f)));
    if (int4_bits(met))
        lanes_divide(at, determinant);
    return met & (at->t > ray->t_min);
}

// The closest of the four, if it is closer than *hit.
static inline bool lanes_reduce(const LaneHits *best, BvhHit *hit)
{
    Float4 t = float4_min(best->t, (Float4){best->t[1], best->t[0], best->t[3], best->t[2]});
    t = float4_min(t, (Float4){t[2], t[3], t[0], t[1]});
    if (!(t[0] < hit->t))
        return false;
    int lane = __builtin_ctz(int4_bits(best->t == t));
    hit->t = t[0];
    hit->u = best->u[lane];
    hit->v = best->v[lane];
    hit->primitive = (uint32_t)best->id[lane];
    return true;
}

// Without waiting for a division.
static inline Int4 flats_occlude(const FlatPacket *packet, const PacketRay *ray, Float4 t_max)
{
    LaneHits at;
    Float4 size;
    Int4 crossed = flats_crossed(packet, ray, &at, &size);
    return crossed & (at.t > size * ray->t_min) & (at.t < size * t_max) & ~(at.id == ray->except);
}

static inline Int4 spheres_occlude(const SpherePacket *packet, const PacketRay *ray, Float4 t_max)
{
    Float4 t;
    return spheres_hit(packet, ray, &t) & (t < t_max) & ~(int4_load(packet->id) == ray->except);
}
