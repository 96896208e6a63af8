// Bounding volume hierarchy: finds the first of a million surfaces that a ray meets by looking at a few dozen. Built
// by binned surface-area heuristic (Wald 2007), then collapsed to wide nodes whose child boxes are tested together.
#pragma once

#include "base/error.h"
#include "scene/bvh/shape.h"

#include <stddef.h>

typedef struct Bvh Bvh;

typedef struct {
    float t;            // distance along the ray's direction (its length where direction is not unit)
    float u, v;         // on a flat: coordinates along edge_u, edge_v
    uint32_t primitive; // flats first, then spheres
} BvhHit;

// Copies what it needs; the arrays may be freed afterwards. The same tree whatever the number of threads. Degenerate
// primitives must have been refused before. NULL when memory is short. No primitives at all is allowed: nothing is
// ever hit.
Bvh *bvh_build(const Flat *flats, size_t flat_count, const Sphere *spheres, size_t sphere_count, Error *error);
void bvh_free(Bvh *bvh);

// A ray with a NaN, an infinity or no direction hits nothing.
//
// The closest hit with t_min < t < t_max (t_min ≥ 0), both sides of every surface; the direction need not be of unit
// length. The primitive ray.from is not hit where the ray starts: a flat not at all, a sphere only on its far side
// (when the ray goes inside). *hit means nothing where there is none. Of hits at the very same distance, among more than 16 flats
// or spheres, that on the primitive with the highest number.
bool bvh_closest(const Bvh *bvh, const Ray *ray, float t_min, float t_max, BvhHit *hit);

// Is there any hit with t_min < t < t_max, other than on primitive `except` (NO_PRIMITIVE: none excepted)?
bool bvh_occluded(const Bvh *bvh, const Ray *ray, float t_min, float t_max, uint32_t except);

Box bvh_bounds(const Bvh *bvh); // of everything; box_empty() when there is nothing
