// How large and how small a scene may be. Rays are followed in single precision, where the square of an area
// must still be a number: that bounds lengths on both sides.
#ifndef PHOTONLAB_SCENE_LIMITS_H
#define PHOTONLAB_SCENE_LIMITS_H

#include "math/vec3.h"

#include <float.h>
#include <stdbool.h>

#define SCENE_LARGEST_NUMBER  1e9 // of any number in a scene file or mesh
#define SCENE_SMALLEST_LENGTH 1e-9f

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

#endif
