// Samplers for the library's own use (the eye pass, the path tracer and the light sources that are no exercise), each
// beside its density. The path tracer must not lean on a student's steps: it is there to check them.
#pragma once

#include "math/frame.h"
#include "math/rng.h"

// Uniform on the unit disk (z = 0) from (u, v) in [0,1)²; density 1/π.
static inline Vec3 sample_disk(float u, float v)
{
    float r = sqrtf(u);
    float phi = 2.0f * PI * v;
    return vec3(r * cosf(phi), r * sinf(phi), 0.0f);
}

// The unit vector of height z that a share `turn` of a whole turn about z leads to.
static inline Vec3 direction_at(float z, float turn)
{
    float r = sqrtf(fmaxf(0.0f, 1.0f - z * z));
    float phi = 2.0f * PI * turn;
    return vec3(r * cosf(phi), r * sinf(phi), z);
}

// Uniform on the unit sphere; density 1/(4π).
static inline Vec3 sample_sphere(float u, float v)
{
    return direction_at(1.0f - 2.0f * u, v);
}

// Uniform in the cone of directions about z with cosine of the half angle cos_max; density 1/(2π(1−cos_max)).
static inline Vec3 sample_cone(float cos_max, float u, float v)
{
    return direction_at(1.0f - u * (1.0f - cos_max), v);
}

// Cosine-weighted about n: a point on the disk, lifted to the hemisphere (Malley's method); density cosθ/π.
static inline Vec3 sample_cosine(Vec3 n, float u, float v)
{
    Frame frame = frame_about(n);
    Vec3 d = sample_disk(u, v);
    d.z = sqrtf(fmaxf(0.0f, 1.0f - u));
    return frame_to_world(&frame, d);
}
