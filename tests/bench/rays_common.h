// Meshes and rays for the benchmark of rays.
#pragma once

#include "bench_common.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#define BENCH_PI    3.14159265358979323846
#define BENCH_T_MIN 1e-4f

typedef struct {
    float *vertices; // x, y, z each
    size_t vertex_count;
    uint32_t *triangles; // three vertex numbers each
    size_t triangle_count;
} BenchMesh;

typedef struct {
    float origin[3], direction[3];
    float t_max;
} BenchRay;

static void add_triangle(BenchMesh *mesh, size_t a, size_t b, size_t c)
{
    uint32_t *corner = &mesh->triangles[3 * mesh->triangle_count++];
    corner[0] = (uint32_t)a;
    corner[1] = (uint32_t)b;
    corner[2] = (uint32_t)c;
}

static void add_vertex(BenchMesh *mesh, double x, double y, double z)
{
    float *vertex = &mesh->vertices[3 * mesh->vertex_count++];
    vertex[0] = (float)x;
    vertex[1] = (float)y;
    vertex[2] = (float)z;
}

// A sphere of `around` segments about the y axis and `down` from pole to pole; with a wavy surface if asked.
static void add_sphere(BenchMesh *mesh, int around, int down, const float centre[3], float radius, bool wavy)
{
    size_t base = mesh->vertex_count;
    for (int j = 0; j <= down; j++)
        for (int i = 0; i < around; i++) {
            double theta = BENCH_PI * j / down;
            double phi = 2 * BENCH_PI * i / around;
            double r = radius;
            if (wavy)
                r *= 1 + 0.05 * sin(13 * theta) * sin(17 * phi) + 0.02 * sin(57 * theta + 1) * cos(61 * phi);
            add_vertex(mesh, centre[0] + r * sin(theta) * cos(phi), centre[1] + r * cos(theta),
                       centre[2] + r * sin(theta) * sin(phi));
        }
    for (int j = 0; j < down; j++)
        for (int i = 0; i < around; i++) {
            size_t a = base + (size_t)(j * around + i);
            size_t b = base + (size_t)(j * around + (i + 1) % around);
            if (j > 0)
                add_triangle(mesh, a, b, a + (size_t)around);
            if (j < down - 1)
                add_triangle(mesh, b, b + (size_t)around, a + (size_t)around);
        }
}

// A rectangle between two opposite corners, in the plane where the corners agree on `axis`.
static void add_wall(BenchMesh *mesh, int axis, const float low[3], const float high[3])
{
    size_t base = mesh->vertex_count;
    int u = (axis + 1) % 3;
    for (int corner = 0; corner < 4; corner++) {
        float p[3] = {low[0], low[1], low[2]};
        if (corner == 1 || corner == 2)
            p[u] = high[u];
        if (corner >= 2)
            p[3 - u - axis] = high[3 - u - axis];
        add_vertex(mesh, p[0], p[1], p[2]);
    }
    add_triangle(mesh, base, base + 1, base + 2);
    add_triangle(mesh, base, base + 2, base + 3);
}

// "box": five walls, a lamp and two spheres of 20 000 triangles. "mesh": one wavy sphere of a million.
static BenchMesh mesh_create(bool box)
{
    BenchMesh mesh = {bench_allocate(600000 * 3, sizeof(float)), 0, bench_allocate(1100000 * 3, sizeof(uint32_t)), 0};
    if (!box) {
        add_sphere(&mesh, 1000, 501, (float[]){0, 0, 0}, 1.0f, true);
        return mesh;
    }
    add_wall(&mesh, 1, (float[]){-1, -1, -1}, (float[]){1, -1, 1});
    add_wall(&mesh, 1, (float[]){-1, 1, -1}, (float[]){1, 1, 1});
    add_wall(&mesh, 2, (float[]){-1, -1, -1}, (float[]){1, 1, -1});
    add_wall(&mesh, 0, (float[]){-1, -1, -1}, (float[]){-1, 1, 1});
    add_wall(&mesh, 0, (float[]){1, -1, -1}, (float[]){1, 1, 1});
    add_wall(&mesh, 1, (float[]){-0.23f, 0.99f, -0.18f}, (float[]){0.23f, 0.99f, 0.2f});
    add_sphere(&mesh, 101, 100, (float[]){-0.42f, -0.65f, -0.30f}, 0.35f, false);
    add_sphere(&mesh, 101, 100, (float[]){0.40f, -0.65f, 0.25f}, 0.35f, false);
    return mesh;
}

static void unit_direction(uint64_t *random, float direction[3])
{
    float z = 2 * bench_random(random) - 1;
    float phi = (float)(2 * BENCH_PI * bench_random(random));
    float s = sqrtf(fmaxf(0.0f, 1 - z * z));
    direction[0] = s * cosf(phi);
    direction[1] = s * sinf(phi);
    direction[2] = z;
}

static void cube_point(uint64_t *random, float point[3])
{
    for (int k = 0; k < 3; k++)
        point[k] = 2 * bench_random(random) - 1;
}

// From a sphere of radius 2 to a point of the unit ball.
static BenchRay ray_inwards(uint64_t *random)
{
    BenchRay ray = {.t_max = INFINITY};
    float target[3];
    float length2 = 0;
    unit_direction(random, ray.origin);
    for (int k = 0; k < 3; k++)
        ray.origin[k] *= 2;
    do
        cube_point(random, target);
    while (target[0] * target[0] + target[1] * target[1] + target[2] * target[2] > 1);
    for (int k = 0; k < 3; k++) {
        ray.direction[k] = target[k] - ray.origin[k];
        length2 += ray.direction[k] * ray.direction[k];
    }
    for (int k = 0; k < 3; k++)
        ray.direction[k] *= 1 / sqrtf(length2);
    return ray;
}

// In the box: any direction from any point, or (shadow) from any point to just before any other.
static BenchRay ray_in_box(uint64_t *random, bool shadow)
{
    BenchRay ray = {.t_max = shadow ? 0.999f : INFINITY};
    cube_point(random, ray.origin);
    if (!shadow) {
        unit_direction(random, ray.direction);
        return ray;
    }
    cube_point(random, ray.direction);
    for (int k = 0; k < 3; k++)
        ray.direction[k] -= ray.origin[k];
    return ray;
}

static BenchRay *rays_incoherent(bool box, bool shadow, size_t count)
{
    BenchRay *rays = bench_allocate(count, sizeof *rays);
    uint64_t random = 12345;
    for (size_t i = 0; i < count; i++)
        rays[i] = box ? ray_in_box(&random, shadow) : ray_inwards(&random);
    return rays;
}

// 512 × 512 pixels of 2 × 2 rays, in reading order.
static BenchRay *rays_camera(size_t *count)
{
    float slope = (float)tan(39.3077 * BENCH_PI / 360);
    BenchRay *rays = bench_allocate((size_t)512 * 512 * 4, sizeof *rays);
    *count = 0;
    for (int y = 0; y < 512; y++)
        for (int x = 0; x < 512; x++)
            for (int s = 0; s < 4; s++) {
                float u = ((float)x + 0.25f + 0.5f * (float)(s & 1)) / 256 - 1;
                float v = 1 - ((float)y + 0.25f + 0.5f * (float)(s >> 1)) / 256;
                rays[(*count)++] = (BenchRay){{0, 0, 3.9f}, {u * slope, v * slope, -1}, INFINITY};
            }
    return rays;
}
