// The preview's camera: it looks at a target and turns about it.
#pragma once

#include "scene/camera.h"

typedef struct {
    Vec3 target;        // m
    float distance;     // m, from the target
    float yaw, pitch;   // radians: yaw about +y, 0 looks along −z; pitch −π/2…π/2, positive looks down
    float vertical_fov; // degrees
} Orbit;

// Where the scene's own camera stands, turning about the point of its view axis that is nearest the box's centre.
Orbit orbit_of_camera(const Camera *camera, Box scene);
// From position to target; where they are the same place, along −z. Straight up or down, yaw is 0.
Orbit orbit_look(Vec3 position, Vec3 target, float vertical_fov);
// The same direction, moved so that the box fills the view.
void orbit_frame(Orbit *orbit, Box box, float aspect);
// Radians, as if the scene were held by its front: right turns it to the right, up raises the camera.
void orbit_turn(Orbit *orbit, float right, float up);
void orbit_pan(Orbit *orbit, float right, float up); // in parts of the view's height
void orbit_zoom(Orbit *orbit, float factor);         // of the distance
Camera orbit_camera(const Orbit *orbit);
// Column-major, for clip space; near and far planes follow from the box.
void orbit_projection(const Orbit *orbit, Box scene, float aspect, float matrix[16]);
