// Vectors: positions in metres and directions, by value.
#pragma once

#include <math.h>

#define PI 3.14159265358979323846f

typedef struct {
    float x, y, z;
} Vec3;

static inline Vec3 vec3(float x, float y, float z)
{
    return (Vec3){x, y, z};
}

static inline Vec3 vec3_add(Vec3 a, Vec3 b)
{
    return vec3(a.x + b.x, a.y + b.y, a.z + b.z);
}

static inline Vec3 vec3_sub(Vec3 a, Vec3 b)
{
    return vec3(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline Vec3 vec3_scale(Vec3 a, float s)
{
    return vec3(a.x * s, a.y * s, a.z * s);
}

static inline Vec3 vec3_negate(Vec3 a)
{
    return vec3(-a.x, -a.y, -a.z);
}

static inline float vec3_dot(Vec3 a, Vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline Vec3 vec3_cross(Vec3 a, Vec3 b)
{
    return vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static inline float vec3_length(Vec3 a)
{
    return sqrtf(vec3_dot(a, a));
}

// The unit vector along `a`; `a` must not be zero.
static inline Vec3 vec3_normalize(Vec3 a)
{
    return vec3_scale(a, 1.0f / vec3_length(a));
}

// a + s·b: the point that lies s along b from a.
static inline Vec3 vec3_along(Vec3 a, Vec3 b, float s)
{
    return vec3(a.x + s * b.x, a.y + s * b.y, a.z + s * b.z);
}

// Component 0, 1 or 2.
static inline float vec3_component(Vec3 a, int axis)
{
    return axis == 0 ? a.x : axis == 1 ? a.y : a.z;
}
