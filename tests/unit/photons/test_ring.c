// The caustics of a mirror ring, through real photon tracing.
#include "unit/test_common.h"

#define RING_RADIUS 0.1 // m, of scenes/ring.yaml

// A photon's way over the floor, seen from above, in units of the ring's radius: x along the light, (cos t, sin t)
// where it left the mirror. False for photons that were not reflected exactly once, or not inside the ring.
typedef struct {
    double x, y, dx, dy, t;
} RingRay;

static bool ring_ray(const StoredPhoton *photon, RingRay *ray)
{
    Vec3 wi = stored_photon_wi(photon);
    ray->x = -(double)photon->position.x / RING_RADIUS; // the light falls along −x
    ray->y = (double)photon->position.z / RING_RADIUS;
    double flat = hypot((double)wi.x, (double)wi.z);
    ray->dx = (double)wi.x / flat;
    ray->dy = -(double)wi.z / flat;
    double outside2 = 1.0 - ray->x * ray->x - ray->y * ray->y;
    if (photon->bounce != 1 || photon->path != PATH_CAUSTIC || outside2 <= 0.0)
        return false;
    double b = ray->x * ray->dx + ray->y * ray->dy;
    double back = b + sqrt(b * b + outside2); // to the circle, against the flight
    ray->t = DEGREES * atan2(ray->y - back * ray->dy, ray->x - back * ray->dx);
    return true;
}

// Where neighbouring rays cross: the point of least squared distance to those that left within 1.5° of t.
static void crossing(const PhotonPass *pass, double t, double *x, double *y)
{
    double axx = 0.0, axy = 0.0, ayy = 0.0, bx = 0.0, by = 0.0;
    long rays = 0;
    for (size_t i = 0; i < pass->rest.count; i++) {
        RingRay ray;
        if (!ring_ray(&pass->rest.photons[i], &ray) || fabs(ray.t - t) > 1.5)
            continue;
        double nx = -ray.dy, ny = ray.dx, distance = nx * ray.x + ny * ray.y;
        axx += nx * nx;
        axy += nx * ny;
        ayy += ny * ny;
        bx += nx * distance;
        by += ny * distance;
        rays++;
    }
    assert_true(rays >= 20);
    double determinant = axx * ayy - axy * axy;
    *x = (bx * ayy - by * axy) / determinant;
    *y = (axx * by - axy * bx) / determinant;
}

// Parallel light: half a nephroid ((3cos t − cos 3t)/4, (3sin t − sin 3t)/4), its cusp at R/2. Beyond t = 78°
// light meets the mirror a second time before it reaches the floor.
TEST(parallel_light_in_a_ring_makes_a_nephroid)
{
    Scene *scene = scene_from_file("scenes/ring.yaml");
    PhotonPass pass = photons_of(scene, FEWER(400000), 1, PLAY_DEFAULT);
    for (int t = -70; t <= 70; t += 10) {
        double x, y, a = t / DEGREES;
        crossing(&pass, t, &x, &y);
        assert_within(x, (3.0 * cos(a) - cos(3.0 * a)) / 4.0, 0.01, "nephroid x");
        assert_within(y, (3.0 * sin(a) - sin(3.0 * a)) / 4.0, 0.01, "nephroid y");
        if (t == 0)
            assert_within(x, 0.5, 0.003, "cusp of the nephroid");
    }
}

// A source on the rim at (−1, 0): a cardioid. The mirror's formula 1/s + 1/q = 2/cos i (R = 1), with the
// incidence i = t/2 and the source's distance s = 2cos i, gives q = (2/3)cos i: the rays cross that far from
// the mirror, reflected to angle 2i about the way to the source. Cusp at R/3.
TEST(source_on_the_rim_makes_a_cardioid)
{
    Scene *scene = scene_from_file("scenes/ring.yaml");
    scene->lights[0] = (Light){.type = LIGHT_POINT,
                               .position = vec3(0.9999f * (float)RING_RADIUS, 0.02f, 0.0f),
                               .power = colour_grey(1.0f),
                               .primitive = NO_PRIMITIVE};
    PhotonPass pass = photons_of(scene, 400000, 1, PLAY_DEFAULT);
    for (int t = -80; t <= 80; t += 10) {
        double x, y, a = t / DEGREES, q = 2.0 / 3.0 * cos(0.5 * a);
        crossing(&pass, t, &x, &y);
        assert_within(x, cos(a) - q * cos(1.5 * a), 0.01, "cardioid x");
        assert_within(y, sin(a) - q * sin(1.5 * a), 0.01, "cardioid y");
        if (t == 0)
            assert_within(x, 1.0 / 3.0, 0.003, "cusp of the cardioid");
    }
}
