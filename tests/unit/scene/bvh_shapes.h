// Shapes for the tests of the hierarchy.
#pragma once

#include "math/rng.h"
#include "scene/bvh/bvh.h"
#include "unit/test.h"

#define MAX_SHAPES 20000

typedef struct {
    Flat flats[MAX_SHAPES];
    Sphere spheres[MAX_SHAPES];
    size_t flat_count, sphere_count;
} Shapes;

static Shapes shapes; // of the test that runs; too large for the stack

FREED_AT_END(own_bvh, Bvh, bvh_free)

static inline Bvh *build(void)
{
    Bvh *bvh = bvh_build(shapes.flats, shapes.flat_count, shapes.spheres, shapes.sphere_count, &said);
    assert_non_null(bvh);
    assert_string_equal(said.message, "");
    return own_bvh(bvh);
}

static inline bool meets(const Bvh *bvh, const Ray *ray, BvhHit *hit)
{
    return bvh_closest(bvh, ray, 0.0f, INFINITY, hit);
}

static inline bool is_blocked(const Bvh *bvh, const Ray *ray)
{
    return bvh_occluded(bvh, ray, 0.0f, INFINITY, NO_PRIMITIVE);
}

static inline float between(Rng *rng, float low, float high)
{
    return low + (high - low) * rng_float(rng);
}

static inline Vec3 random_point(Rng *rng, float size)
{
    float x = between(rng, -size, size);
    float y = between(rng, -size, size);
    float z = between(rng, -size, size);
    return vec3(x, y, z);
}

static inline void add_flat(Vec3 origin, Vec3 edge_u, Vec3 edge_v, bool triangle)
{
    shapes.flats[shapes.flat_count++] =
        (Flat){.origin = origin, .edge_u = edge_u, .edge_v = edge_v, .is_triangle = triangle};
}

static inline void add_sphere(Vec3 centre, float radius)
{
    shapes.spheres[shapes.sphere_count++] = (Sphere){.centre = centre, .radius = radius};
}

static inline void random_shapes(Rng *rng, size_t count, float size)
{
    memset(&shapes, 0, sizeof shapes);
    for (size_t i = 0; i < count; i++) {
        Vec3 place = random_point(rng, 1.0f);
        if (i % 3 == 2) {
            add_sphere(place, between(rng, 0.1f, 1.0f) * size);
        } else {
            Vec3 u = random_point(rng, size);
            Vec3 v = random_point(rng, size);
            add_flat(place, u, v, i % 3 == 0);
        }
    }
}

// A closed cube about `centre`.
static inline void add_cube(Vec3 centre, float half)
{
    for (int axis = 0; axis < 3; axis++)
        for (int side = -1; side <= 1; side += 2) {
            float corner[3] = {-half, -half, -half}, u[3] = {0}, v[3] = {0};
            corner[axis] = (float)side * half;
            u[(axis + 1) % 3] = 2 * half;
            v[(axis + 2) % 3] = 2 * half;
            add_flat(vec3_add(centre, vec3(corner[0], corner[1], corner[2])), vec3(u[0], u[1], u[2]),
                     vec3(v[0], v[1], v[2]), false);
        }
}
