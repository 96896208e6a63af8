// Pinhole camera.
#pragma once

#include "math/ray.h"

typedef struct {
    Vec3 position;
    Vec3 forward, right, up; // unit, at right angles
    float tan_half_fov;      // tangent of half the vertical field of view
} Camera;

// The ray through a point of the film: x from 0 (left) to 1 (right), y from 0 (top) to 1 (bottom).
static inline Ray camera_ray(const Camera *camera, float x, float y, float aspect)
{
    float sideways = (2.0f * x - 1.0f) * camera->tan_half_fov * aspect;
    float upwards = (1.0f - 2.0f * y) * camera->tan_half_fov;
    Vec3 direction = vec3_along(camera->forward, camera->right, sideways);
    direction = vec3_along(direction, camera->up, upwards);
    return (Ray){camera->position, vec3_normalize(direction), NO_PRIMITIVE};
}
