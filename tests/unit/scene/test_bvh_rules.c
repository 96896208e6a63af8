// The rules that bvh.h promises.
#include "unit/scene/bvh_shapes.h"

#ifdef _OPENMP
#include <omp.h>
#endif

TEST(test_nothing)
{
    memset(&shapes, 0, sizeof shapes);
    Bvh *bvh = build();
    Ray ray = {vec3(0, 0, 0), vec3(0, 0, 1), NO_PRIMITIVE};
    BvhHit hit;
    assert_false(meets(bvh, &ray, &hit));
    assert_false(is_blocked(bvh, &ray));
    assert_true(bvh_bounds(bvh).low.x > bvh_bounds(bvh).high.x);
    bvh_free(NULL);
}

// Rays that run exactly in the planes of box faces: 0·∞ in the box test must lose nothing.
TEST(test_along_faces)
{
    memset(&shapes, 0, sizeof shapes);
    for (int i = 0; i < 64; i++)
        add_cube(vec3((float)(i & 3), (float)(i >> 2 & 3), (float)(i >> 4)), 0.25f);
    Bvh *bvh = build();
    for (int i = 0; i < 16; i++)
        for (int axis = 0; axis < 3; axis++)
            for (int corner = 0; corner < 4; corner++) {
                float o[3] = {-3, -3, -3}, d[3] = {0.0f, -0.0f, 0.0f};
                o[(axis + 1) % 3] = (float)(i & 3) + (corner & 1 ? 0.25f : -0.25f);
                o[(axis + 2) % 3] = (float)(i >> 2) + (corner & 2 ? 0.25f : 0.1f);
                d[axis] = 1;
                Ray ray = {vec3(o[0], o[1], o[2]), vec3(d[0], d[1], d[2]), NO_PRIMITIVE};
                BvhHit hit;
                assert_true(meets(bvh, &ray, &hit));
                assert_float_equal(hit.t, 2.75f, 1e-5);
                assert_true(is_blocked(bvh, &ray));
            }
}

// A closed room, many times: from any wall in any inward direction another wall is met, never the same one
// and never none.
TEST(test_leaving_flats)
{
    Rng rng = rng_create(5, 0);
    memset(&shapes, 0, sizeof shapes);
    add_cube(vec3(3, -2, 0.7f), 1.3f);
    Bvh *bvh = build();
    for (int i = 0; i < 300000; i++) {
        uint32_t wall = (uint32_t)(i % 6);
        const Flat *flat = &shapes.flats[wall];
        float u = rng_float(&rng);
        float v = rng_float(&rng);
        Ray ray = {vec3_along(vec3_along(flat->origin, flat->edge_u, u), flat->edge_v, v), random_point(&rng, 1), wall};
        Vec3 middle = vec3_sub(vec3(3, -2, 0.7f), ray.origin);
        Vec3 normal = vec3_cross(flat->edge_u, flat->edge_v);
        if (vec3_dot(normal, middle) * vec3_dot(normal, ray.direction) < 0)
            ray.direction = vec3_negate(ray.direction);
        BvhHit hit;
        assert_true(meets(bvh, &ray, &hit));
        assert_int_not_equal(hit.primitive, wall);
    }
}

// Analytic: inwards a sphere is met again at t = −2 (o−c)·d/(d·d), outwards never.
TEST(test_leaving_spheres)
{
    Rng rng = rng_create(6, 0);
    for (int i = 0; i < 2000; i++) {
        memset(&shapes, 0, sizeof shapes);
        float radius = ldexpf(1.0f, i % 24 - 12);
        add_sphere(random_point(&rng, 3), radius);
        Bvh *bvh = build();
        Vec3 out = vec3_normalize(random_point(&rng, 1));
        Vec3 d = random_point(&rng, 1);
        Ray ray = {vec3_along(shapes.spheres[0].centre, out, radius), d, 0};
        Vec3 o = vec3_sub(ray.origin, shapes.spheres[0].centre);
        float t = -2 * vec3_dot(o, d) / vec3_dot(d, d);
        BvhHit hit = {0};
        assert_int_equal(meets(bvh, &ray, &hit), t > 0);
        assert_int_equal(is_blocked(bvh, &ray), t > 0);
        if (t > 0)
            assert_float_equal(hit.t, t, 1e-5 * t);
        assert_false(bvh_occluded(bvh, &ray, 0.0f, INFINITY, 0));
    }
}

// Where b² − 4ac in single precision has no correct digit left: small and far, huge and near.
TEST(test_sphere_precision)
{
    memset(&shapes, 0, sizeof shapes);
    add_sphere(vec3(0, 0, 0), 0.01f);
    add_sphere(vec3(0, -100010.0f, 0), 100000.0f);
    Bvh *bvh = build();
    BvhHit hit = {0};
    Ray far = {vec3(1000, 0.005f, 0), vec3(-1, 0, 0), NO_PRIMITIVE};
    assert_true(meets(bvh, &far, &hit));
    assert_float_equal(hit.t, 1000 - sqrt(0.01 * 0.01 - 0.005 * 0.005), 1e-4);
    Ray near = {vec3(0, -9, 0), vec3(0.6f, -0.8f, 0), NO_PRIMITIVE};
    assert_true(meets(bvh, &near, &hit));
    assert_float_equal(hit.t, 1.25, 0.02);
    assert_int_equal(hit.primitive, 1);
}

TEST(test_interval_length_and_except)
{
    memset(&shapes, 0, sizeof shapes);
    add_flat(vec3(-1, -1, 2), vec3(2, 0, 0), vec3(0, 2, 0), false);
    add_flat(vec3(-1, -1, 4), vec3(4, 0, 0), vec3(0, 4, 0), true);
    Bvh *bvh = build();
    Ray ray = {vec3(0, 0, 0), vec3(0, 0, 1), NO_PRIMITIVE};
    BvhHit hit;
    assert_true(meets(bvh, &ray, &hit));
    assert_true(hit.t == 2.0f && hit.primitive == 0 && hit.u == 0.5f && hit.v == 0.5f);
    assert_true(bvh_closest(bvh, &ray, 2.0f, INFINITY, &hit));
    assert_true(hit.t == 4.0f && hit.primitive == 1 && hit.u == 0.25f && hit.v == 0.25f);
    assert_false(bvh_closest(bvh, &ray, 2.0f, 4.0f, &hit));
    assert_false(bvh_occluded(bvh, &ray, 2.0f, 4.0f, NO_PRIMITIVE));
    assert_false(bvh_occluded(bvh, &ray, 0.0f, 4.0f, 0));
    assert_true(bvh_occluded(bvh, &ray, 0.0f, 4.1f, 0));
    ray.direction = vec3(0, 0, 8);
    assert_true(meets(bvh, &ray, &hit));
    assert_true(hit.t == 0.25f);
    ray.from = 0;
    assert_true(meets(bvh, &ray, &hit));
    assert_true(hit.t == 0.5f);
    ray.direction = vec3(0.26f, 0.26f, 1); // beyond the triangle's long edge …
    assert_false(is_blocked(bvh, &ray));
    ray.direction = vec3(0.24f, 0.24f, 1); // … and just before it
    assert_true(is_blocked(bvh, &ray));
}

// The same hits, bit by bit, from trees built by one thread and by several.
TEST(test_threads)
{
    Rng rng = rng_create(7, 0);
    random_shapes(&rng, MAX_SHAPES, 0.03f);
#ifdef _OPENMP
    omp_set_num_threads(1);
#endif
    Bvh *one = build();
#ifdef _OPENMP
    omp_set_num_threads(4);
#endif
    Bvh *several = build();
    for (int i = 0; i < 20000; i++) {
        Ray ray = {random_point(&rng, 1), random_point(&rng, 1), NO_PRIMITIVE};
        BvhHit a, b;
        memset(&a, 0, sizeof a);
        memset(&b, 0, sizeof b);
        assert_int_equal(meets(one, &ray, &a), meets(several, &ray, &b));
        assert_memory_equal(&a, &b, sizeof a);
    }
}

// What a student's step may send: in a tree with empty places beside real children.
TEST(test_unsound_rays)
{
    memset(&shapes, 0, sizeof shapes);
    for (int i = 0; i < 30; i++) {
        add_flat(vec3((float)i, 0, 0), vec3(0.5f, 0, 0), vec3(0, 0.5f, 0), i % 2 == 0);
        add_sphere(vec3((float)i, 3, 0), 0.4f);
    }
    Bvh *bvh = build();
    const float bad[] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 3; i++)
        for (int axis = 0; axis < 6; axis++) {
            float v[6] = {0.1f, 0.1f, -1.0f, 0.0f, 0.0f, 1.0f};
            v[axis] = bad[i];
            Ray ray = {vec3(v[0], v[1], v[2]), vec3(v[3], v[4], v[5]), NO_PRIMITIVE};
            BvhHit hit;
            assert_false(meets(bvh, &ray, &hit));
            assert_false(is_blocked(bvh, &ray));
        }
    Ray still = {vec3(0.1f, 0.1f, -1.0f), vec3(0, 0, 0), NO_PRIMITIVE};
    BvhHit hit;
    assert_false(meets(bvh, &still, &hit));
}

// Of what lies at one distance the last is hit, in whatever order the tree was built and searched.
TEST(test_one_distance)
{
    memset(&shapes, 0, sizeof shapes);
    for (int i = 0; i < 200; i++)
        add_flat(vec3((float)(i % 7), 0, 0), vec3(10, 0, 0), vec3(0, 10, 0), i % 2);
    Bvh *bvh = build();
    BvhHit hit;
    assert_true(meets(bvh, &(Ray){vec3(8, 0.5f, 3), vec3(0, 0, -1), NO_PRIMITIVE}, &hit));
    assert_int_equal(hit.primitive, 199);
    assert_true(meets(bvh, &(Ray){vec3(0.5f, 0.5f, -3), vec3(0, 0, 1), NO_PRIMITIVE}, &hit));
    assert_int_equal(hit.primitive, 196);
}

TEST(test_bounds)
{
    memset(&shapes, 0, sizeof shapes);
    add_flat(vec3(0, 0, 0), vec3(1, 0, 0), vec3(0, 2, 0), false);
    add_sphere(vec3(0, 0, 3), 0.5f);
    Bvh *bvh = build();
    Box box = bvh_bounds(bvh);
    assert_true(box.low.x == -0.5f && box.low.y == -0.5f && box.low.z == 0.0f);
    assert_true(box.high.x == 1.0f && box.high.y == 2.0f && box.high.z == 3.5f);
}
