// The hierarchy against brute force in double precision.
#include "unit/scene/bvh_shapes.h"

static void cross(const double a[3], const double b[3], double result[3])
{
    for (int i = 0; i < 3; i++)
        result[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Distance to a flat that is larger by `slack` (relative to its edges), or infinity.
static double flat_distance(const Flat *f, const Ray *ray, double t_min, double slack)
{
    const double u[3] = {f->edge_u.x, f->edge_u.y, f->edge_u.z}, v[3] = {f->edge_v.x, f->edge_v.y, f->edge_v.z};
    const double d[3] = {ray->direction.x, ray->direction.y, ray->direction.z};
    const double p[3] = {(double)ray->origin.x - f->origin.x, (double)ray->origin.y - f->origin.y,
                         (double)ray->origin.z - f->origin.z};
    double normal[3], moment[3];
    cross(u, v, normal);
    cross(d, p, moment);
    double determinant = dot(normal, d);
    if (determinant == 0)
        return INFINITY;
    double t = -dot(normal, p) / determinant;
    double s = dot(v, moment) / determinant;
    double r = -dot(u, moment) / determinant;
    bool inside = s >= -slack && r >= -slack && r <= 1 + slack && s + (f->is_triangle ? r : 0) <= 1 + slack;
    return inside && t > t_min ? t : INFINITY;
}

static double sphere_distance(const Sphere *sphere, const Ray *ray, double t_min, bool leaving, double slack)
{
    const double d[3] = {ray->direction.x, ray->direction.y, ray->direction.z};
    const double f[3] = {(double)ray->origin.x - sphere->centre.x, (double)ray->origin.y - sphere->centre.y,
                         (double)ray->origin.z - sphere->centre.z};
    double radius = sphere->radius * (1 + slack);
    double a = dot(d, d), b = -dot(f, d);
    if (leaving)
        return b > 0 && 2 * b / a > t_min ? 2 * b / a : INFINITY;
    double discriminant = b * b - a * (dot(f, f) - radius * radius);
    if (discriminant < 0)
        return INFINITY;
    double near = (b - sqrt(discriminant)) / a, far = (b + sqrt(discriminant)) / a;
    return near > t_min ? near : far > t_min ? far : INFINITY;
}

static double shape_distance(uint32_t i, const Ray *ray, double t_min, double slack)
{
    if (i >= shapes.flat_count)
        return sphere_distance(&shapes.spheres[i - shapes.flat_count], ray, t_min, ray->from == i, slack);
    return ray->from == i ? INFINITY : flat_distance(&shapes.flats[i], ray, t_min, slack);
}

// A ray within rounding of an edge may hit or miss. So: the closest hit lies between `low` and `high`, with
// each shape a little larger and a little smaller than it is.
static void brute_force(const Ray *ray, double t_min, double slack, double *low, double *high)
{
    *low = INFINITY;
    *high = INFINITY;
    for (uint32_t i = 0; i < shapes.flat_count + shapes.sphere_count; i++) {
        double exact = shape_distance(i, ray, t_min, 0);
        double larger = shape_distance(i, ray, t_min, slack);
        double smaller = shape_distance(i, ray, t_min, -slack);
        *low = fmin(*low, fmin(exact, fmin(larger, smaller)));
        *high = fmin(*high, fmax(exact, fmax(larger, smaller)));
    }
}

static void check_ray(const Bvh *bvh, const Ray *ray, float t_min)
{
    const double slack = 1e-4;
    double low, high;
    brute_force(ray, t_min, slack, &low, &high);
    BvhHit hit = {0};
    bool found = bvh_closest(bvh, ray, t_min, INFINITY, &hit);
    double t = found ? hit.t : INFINITY;
    if (!(t >= low * (1 - slack) - slack && (t == high || t <= high * (1 + slack) + slack)))
        fail_msg("hit at %g, expected %g … %g", t, low, high);
    assert_int_equal(bvh_occluded(bvh, ray, t_min, INFINITY, NO_PRIMITIVE), found);
    if (!found)
        return;
    assert_true(hit.t > t_min);
    assert_false(bvh_closest(bvh, ray, t_min, hit.t, &(BvhHit){0}));
    assert_false(bvh_occluded(bvh, ray, t_min, hit.t * (1 - 1e-5f), NO_PRIMITIVE));
    assert_true(bvh_occluded(bvh, ray, t_min, hit.t * (1 + 1e-5f), NO_PRIMITIVE));
    Vec3 there = vec3_along(ray->origin, ray->direction, hit.t);
    if (hit.primitive < shapes.flat_count) {
        const Flat *flat = &shapes.flats[hit.primitive];
        Vec3 same = vec3_along(vec3_along(flat->origin, flat->edge_u, hit.u), flat->edge_v, hit.v);
        assert_true(vec3_length(vec3_sub(there, same)) < 1e-3f);
    } else {
        assert_true(hit.primitive >= shapes.flat_count && hit.primitive < shapes.flat_count + shapes.sphere_count);
        const Sphere *sphere = &shapes.spheres[hit.primitive - shapes.flat_count];
        assert_true(fabsf(vec3_length(vec3_sub(there, sphere->centre)) - sphere->radius) < 1e-3f);
    }
}

static void check_random_rays(Rng *rng, int count)
{
    Bvh *bvh = build();
    for (int i = 0; i < count; i++) {
        Ray ray = {random_point(rng, 1.5f), random_point(rng, 1.0f), NO_PRIMITIVE};
        if (i % 4 == 1)
            ray.direction.y = i % 8 == 1 ? 0.0f : -0.0f;
        if (i % 4 == 2)
            ray.direction = vec3(0.0f, i % 8 == 2 ? 2.0f : -2.0f, -0.0f);
        check_ray(bvh, &ray, i % 3 == 0 ? 0.3f : 0.0f);
    }
}

TEST(test_random_scenes)
{
    const size_t counts[] = {0, 1, 2, 3, 4, 5, 8, 9, 33, 100, 1000};
    Rng rng = rng_create(1, 0);
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        random_shapes(&rng, counts[i], counts[i] > 50 ? 0.1f : 0.7f);
        check_random_rays(&rng, counts[i] > 500 ? 600 : 2000);
    }
}

TEST(test_coincident_centroids)
{
    Rng rng = rng_create(2, 0);
    memset(&shapes, 0, sizeof shapes);
    for (int i = 0; i < 1000; i++) {
        Vec3 u = random_point(&rng, 1.0f);
        Vec3 v = random_point(&rng, 1.0f);
        add_flat(vec3_scale(vec3_add(u, v), -0.5f), u, v, false);
        if (i % 2)
            add_sphere(vec3(0, 0, 0), between(&rng, 0.01f, 0.8f));
    }
    check_random_rays(&rng, 400);
}

// Sizes that double: each cut parts one shape from the rest, so that the tree would become a list.
TEST(test_deep_tree)
{
    Rng rng = rng_create(3, 0);
    memset(&shapes, 0, sizeof shapes);
    for (int i = 0; i < 55; i++) {
        float size = ldexpf(1.0f, -i);
        for (int j = 0; j < 5; j++)
            add_flat(vec3(size, 0, 0), vec3(0, size, 0), vec3(0, 0, size), j % 2);
        add_sphere(vec3(-size, 0, 0), size / 4);
    }
    check_random_rays(&rng, 600);
}

TEST(test_all_in_a_plane)
{
    Rng rng = rng_create(4, 0);
    memset(&shapes, 0, sizeof shapes);
    for (int i = 0; i < 30; i++)
        for (int j = 0; j < 30; j++)
            add_flat(vec3((float)i / 15 - 1, 0.25f, (float)j / 15 - 1), vec3(0, 0, 1 / 15.0f), vec3(1 / 15.0f, 0, 0),
                     i % 2);
    check_random_rays(&rng, 600);
    Bvh *bvh = build();
    for (int i = 0; i < 1000; i++) {
        Ray ray = {vec3(between(&rng, -2, 2), 0.25f, -2), vec3(rng_float(&rng), 0, 1), NO_PRIMITIVE};
        assert_false(is_blocked(bvh, &ray)); // a flat has no thickness
    }
}
