// The way that a mirror sends a ray: the library's own, so that eye rays do not depend on a student's step 1.1.
#ifndef PHOTONLAB_SCENE_MIRROR_H
#define PHOTONLAB_SCENE_MIRROR_H

#include "math/vec3.h"

static inline Vec3 mirror_direction(Vec3 direction, Vec3 normal)
{
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}

#endif
