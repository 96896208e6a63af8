// Turning a direction from "z is up" coordinates to stand about a given axis.
#pragma once

#include "math/vec3.h"

typedef struct {
    Vec3 tangent, bitangent, normal; // unit, at right angles, right-handed
} Frame;

// Any two directions at right angles to a unit vector, without a branch near the poles (Duff et al. 2017).
static inline Frame frame_about(Vec3 n)
{
    float sign = copysignf(1.0f, n.z);
    float a = -1.0f / (sign + n.z);
    float b = n.x * n.y * a;
    return (Frame){
        .tangent = vec3(1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x),
        .bitangent = vec3(b, sign + n.y * n.y * a, -n.y),
        .normal = n,
    };
}

// x·tangent + y·bitangent + z·normal.
static inline Vec3 frame_to_world(const Frame *frame, Vec3 local)
{
    return vec3(local.x * frame->tangent.x + local.y * frame->bitangent.x + local.z * frame->normal.x,
                local.x * frame->tangent.y + local.y * frame->bitangent.y + local.z * frame->normal.y,
                local.x * frame->tangent.z + local.y * frame->bitangent.z + local.z * frame->normal.z);
}
