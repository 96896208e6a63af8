// What the scene's surfaces are made of, once loaded: flats (triangles and parallelograms) and spheres. A box becomes
// six flats, a prism five, a mesh one per triangle.
#pragma once

#include "math/ray.h"

#include <float.h>
#include <stdbool.h>

// The points origin + u·edge_u + v·edge_v with u, v ≥ 0 and (triangle) u+v ≤ 1 or (parallelogram) u, v ≤ 1.
// The normal edge_u × edge_v points outside.
typedef struct {
    Vec3 origin, edge_u, edge_v;
    uint32_t material; // index into Scene.materials
    // 1 + index into Scene.normals of three corner normals (at origin, +edge_u, +edge_v); 0: it has none.
    uint32_t normals : 31;
    uint32_t is_triangle : 1;
    Vec3 normal; // unit; the hierarchy does without
} Flat;

// Degenerate edges span no flat: the sine of the angle between them is below 1e-6, or edge_u × edge_v is too
// small or too large to be normalised in single precision. Reckoned in double, which the products of four
// lengths need.
static inline bool flat_is_degenerate(Vec3 edge_u, Vec3 edge_v)
{
    double ux = edge_u.x, uy = edge_u.y, uz = edge_u.z, vx = edge_v.x, vy = edge_v.y, vz = edge_v.z;
    double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    double cross2 = x * x + y * y + z * z;
    double u2 = ux * ux + uy * uy + uz * uz, v2 = vx * vx + vy * vy + vz * vz;
    return !(cross2 > 1e-12 * u2 * v2 && cross2 > 4.0 * FLT_MIN && cross2 < 0.25 * FLT_MAX);
}

// The normal points away from the centre.
typedef struct {
    Vec3 centre;
    float radius;
    uint32_t material;
} Sphere;

// A primitive's number: flats first (0 … flat_count−1), then spheres (flat_count …).
