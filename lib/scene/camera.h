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
Camera camera_create(Vec3 position, Vec3 target, Vec3 up, float vertical_fov_degrees);

// The ray through a point of the film: x from 0 (left) to 1 (right), y from 0 (top) to 1 (bottom).
Ray camera_ray(const Camera *camera, float x, float y, float aspect);

#endif
