// Rays and boxes.
#pragma once

#include "math/vec3.h"

#include <stdint.h>

#define NO_PRIMITIVE UINT32_MAX

// A half line. `from` names the primitive that the origin lies on (NO_PRIMITIVE: none), so that the ray does not hit it
// again where it starts. Leaving out hits nearer than some epsilon would do this for scenes of one size only.
typedef struct {
    Vec3 origin;
    Vec3 direction; // unit
    uint32_t from;
} Ray;

// The way that a mirror sends a ray: the library's own, so that eye rays do not depend on a student's step 1.1.
static inline Vec3 mirror_direction(Vec3 direction, Vec3 normal)
{
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}

typedef struct {
    Vec3 low, high; // empty when low > high
} Box;

static inline Box box_empty(void)
{
    return (Box){{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
}

static inline void box_add_point(Box *box, Vec3 p)
{
    Vec3 low = box->low, high = box->high;
    box->low = vec3(p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y, p.z < low.z ? p.z : low.z);
    box->high = vec3(p.x > high.x ? p.x : high.x, p.y > high.y ? p.y : high.y, p.z > high.z ? p.z : high.z);
}

// i from 0 to 7: bit 0 for high x, bit 1 for high y, bit 2 for high z.
static inline Vec3 box_corner(Box box, int i)
{
    return vec3(i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y, i & 4 ? box.high.z : box.low.z);
}

static inline float box_diagonal(Box box)
{
    return vec3_length(vec3_sub(box.high, box.low));
}
