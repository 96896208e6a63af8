// Pinhole camera.
#ifndef PHOTONLAB_SCENE_CAMERA_H
#define PHOTONLAB_SCENE_CAMERA_H

#include "math/ray.h"

typedef struct {
    Vec3 position;
    Vec3 forward, right, up; // unit, at right angles
    float tan_half_fov;      // tangent of half the vertical field of view
} Camera;

// up need not be at right angles to the view, only not along it. Field of view in degrees, 0…180 exclusive.
static inline Camera camera_create(Vec3 position, Vec3 target, Vec3 up, float vertical_fov_degrees)
{
    Vec3 forward = vec3_normalize(vec3_sub(target, position));
    Vec3 right = vec3_normalize(vec3_cross(forward, up));
    return (Camera){
        .position = position,
        .forward = forward,
        .right = right,
        .up = vec3_cross(right, forward),
        .tan_half_fov = tanf(0.5f * vertical_fov_degrees * (PI / 180.0f)),
    };
}

// The ray through a point of the film: x from 0 (left) to 1 (right), y from 0 (top) to 1 (bottom).
static inline Ray camera_ray(const Camera *camera, float x, float y, float aspect)
{
    float sideways = (2.0f * x - 1.0f) * camera->tan_half_fov * aspect;
    float upwards = (1.0f - 2.0f * y) * camera->tan_half_fov;
    Vec3 direction = vec3_along(camera->forward, camera->right, sideways);
    direction = vec3_along(direction, camera->up, upwards);
    return (Ray){camera->position, vec3_normalize(direction), NO_PRIMITIVE};
}

#endif
