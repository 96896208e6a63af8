#include "preview/draw/orbit.h"

#include <stdbool.h>

#define MOST_PITCH    (0.5f * PI)
#define LEAST_BOX     1e-6f
#define NEAREST_PLANE 1e-3f // of the far plane: 24 bits of depth are enough for that

static bool box_is_sound(Box box)
{
    return box.low.x <= box.high.x && isfinite(box.low.x + box.low.y + box.low.z) &&
           isfinite(box.high.x + box.high.y + box.high.z);
}

static float box_radius(Box box)
{
    return fmaxf(0.5f * box_diagonal(box), LEAST_BOX);
}

static Vec3 box_middle(Box box)
{
    return vec3_scale(vec3_add(box.low, box.high), 0.5f);
}

static float clamp(float value, float least, float most)
{
    return fminf(fmaxf(value, least), most);
}

Orbit orbit_of_camera(const Camera *camera, Box scene)
{
    float distance = 1.0f;
    if (box_is_sound(scene)) {
        distance = vec3_dot(vec3_sub(box_middle(scene), camera->position), camera->forward);
        distance = fmaxf(distance, 0.1f * box_radius(scene)); // the scene's middle may lie behind
    }
    float fov = 2.0f * atanf(camera->tan_half_fov) * (180.0f / PI);
    Orbit orbit = orbit_look(camera->position, vec3_along(camera->position, camera->forward, distance), fov);
    if (fabsf(camera->forward.y) > 0.9999f) // straight down or up: only its right tells where it is turned to
        orbit.yaw = atan2f(camera->right.z, camera->right.x);
    return orbit;
}

Orbit orbit_look(Vec3 position, Vec3 target, float vertical_fov)
{
    Vec3 way = vec3_sub(target, position);
    float distance = vec3_length(way);
    if (!(distance > 1e-6f)) {
        way = vec3(0, 0, -1);
        distance = 1.0f;
        target = vec3_add(position, way);
    }
    Orbit orbit = {target, distance, 0, 0, clamp(vertical_fov, 1.0f, 170.0f)};
    float level = sqrtf(way.x * way.x + way.z * way.z);
    orbit.yaw = level > 0.0f ? atan2f(way.x, -way.z) : 0.0f;
    orbit.pitch = clamp(atan2f(-way.y, level), -MOST_PITCH, MOST_PITCH);
    return orbit;
}

void orbit_frame(Orbit *orbit, Box box, float aspect)
{
    if (!box_is_sound(box))
        return;
    Camera camera = orbit_camera(orbit);
    orbit->target = box_middle(box);
    float distance = 0.0f;
    for (int i = 0; i < 8; i++) {
        Vec3 corner = vec3_sub(box_corner(box, i), orbit->target);
        float away = vec3_dot(corner, camera.forward);
        float wide = fabsf(vec3_dot(corner, camera.right)) / (camera.tan_half_fov * aspect);
        float high = fabsf(vec3_dot(corner, camera.up)) / camera.tan_half_fov;
        distance = fmaxf(distance, fmaxf(wide, high) - away);
    }
    orbit->distance = 1.06f * fmaxf(distance, LEAST_BOX);
}

void orbit_turn(Orbit *orbit, float right, float up)
{
    orbit->yaw = remainderf(orbit->yaw + right, 2.0f * PI);
    orbit->pitch = clamp(orbit->pitch + up, -MOST_PITCH, MOST_PITCH);
}

void orbit_pan(Orbit *orbit, float right, float up)
{
    Camera camera = orbit_camera(orbit);
    float height = 2.0f * orbit->distance * camera.tan_half_fov;
    orbit->target = vec3_along(orbit->target, camera.right, right * height);
    orbit->target = vec3_along(orbit->target, camera.up, up * height);
}

void orbit_zoom(Orbit *orbit, float factor)
{
    orbit->distance = clamp(orbit->distance * factor, 1e-5f, 1e7f);
}

Camera orbit_camera(const Orbit *orbit)
{
    float level = cosf(orbit->pitch);
    Vec3 forward = vec3(sinf(orbit->yaw) * level, -sinf(orbit->pitch), -cosf(orbit->yaw) * level);
    Vec3 right = vec3(cosf(orbit->yaw), 0, sinf(orbit->yaw)); // sound straight down, too
    return (Camera){
        .position = vec3_along(orbit->target, forward, -orbit->distance),
        .forward = forward,
        .right = right,
        .up = vec3_cross(right, forward),
        .tan_half_fov = tanf(0.5f * orbit->vertical_fov * (PI / 180.0f)),
    };
}

static void matrix_row(float matrix[16], int row, Vec3 axis, float scale, Vec3 origin, float offset)
{
    matrix[row] = axis.x * scale;
    matrix[4 + row] = axis.y * scale;
    matrix[8 + row] = axis.z * scale;
    matrix[12 + row] = offset - vec3_dot(axis, origin) * scale;
}

void orbit_projection(const Orbit *orbit, Box scene, float aspect, float matrix[16])
{
    Camera camera = orbit_camera(orbit);
    float middle = orbit->distance, radius = orbit->distance;
    if (box_is_sound(scene)) {
        middle = vec3_dot(vec3_sub(box_middle(scene), camera.position), camera.forward);
        radius = 1.05f * box_radius(scene);
    }
    float far_plane = fmaxf(middle + 3.0f * radius, orbit->distance); // photons that leave are seen on their way
    float near_plane = fmaxf(middle - radius, NEAREST_PLANE * far_plane);
    float depth = far_plane - near_plane;
    matrix_row(matrix, 0, camera.right, 1.0f / (camera.tan_half_fov * aspect), camera.position, 0);
    matrix_row(matrix, 1, camera.up, 1.0f / camera.tan_half_fov, camera.position, 0);
    matrix_row(matrix, 2, camera.forward, (far_plane + near_plane) / depth, camera.position,
               -2.0f * far_plane * near_plane / depth);
    matrix_row(matrix, 3, camera.forward, 1, camera.position, 0);
}
