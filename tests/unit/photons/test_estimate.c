// Step 1.6, the radiance estimate, on photon maps whose answer is known. Biases of estimators in general: the
// photon map's own tests.
#include "unit/test_common.h"

#define ROOM 400

static Material grey = {.type = MATERIAL_DIFFUSE, .diffuse = {0.5f, 0.25f, 0.75f}};
static NearPhoton near[PHOTON_MAP_NEAREST_CAPACITY(ROOM)];

static Hit floor_hit(float x, float y)
{
    return (Hit){.position = vec3(x, y, 0), .normal = vec3(0, 0, 1), .face_normal = vec3(0, 0, 1), .material = &grey};
}

static StoredPhoton photon_on_floor(float x, float y, Vec3 wi, float power)
{
    return (StoredPhoton){.position = vec3(x, y, 0), .power = colour_grey(power), .packed_wi = direction_pack(wi)};
}

FREED_AT_END(own_map, PhotonMap, photon_map_free)

static PhotonMap *map_of(const StoredPhoton *photons, size_t count)
{
    StoredPhoton *copy = malloc((count + 1) * sizeof *copy);
    assert_non_null(copy);
    for (size_t i = 0; i < count; i++)
        copy[i] = photons[i];
    PhotonMap *map = photon_map_build(copy, count, NULL);
    assert_non_null(map);
    return own_map(map);
}

// One photon of power Φ at distance d under a cone of radius r: L = ρ/π · Φ · 3(1 − d/r)/(πr²), whatever its slant.
TEST(one_photon_under_the_cone)
{
    Hit hit = floor_hit(0, 0);
    Gather gather = {.k = 10, .radius = 0.5f, .near = near};
    for (int slant = 0; slant < 90; slant += 20) {
        StoredPhoton photon = photon_on_floor(0.3f, 0, tilted(slant), 2.0f);
        PhotonMap *map = map_of(&photon, 1);
        Colour L = steps.estimate_radiance(map, &hit, vec3(0, 0, 1), &gather);
        double per_reflectance = 2.0 / M_PI * 3.0 * (1.0 - 0.3 / 0.5) / (M_PI * 0.25);
        assert_within(L.r, 0.5 * per_reflectance, 1e-5, "red");
        assert_within(L.g, 0.25 * per_reflectance, 1e-5, "green");
        assert_within(L.b, 0.75 * per_reflectance, 1e-5, "blue");
    }
}

TEST(photons_of_the_other_side_do_not_count)
{
    Hit hit = floor_hit(0, 0);
    Gather gather = {.k = 10, .radius = 0.5f, .near = near};
    StoredPhoton photons[2] = {photon_on_floor(0.1f, 0, tilted(30), 1), photon_on_floor(0.1f, 0, tilted(150), 1)};
    PhotonMap *above = map_of(&photons[0], 1), *below = map_of(&photons[1], 1), *both = map_of(photons, 2);
    Colour one = steps.estimate_radiance(above, &hit, vec3(0, 0, 1), &gather);
    assert_true(one.r > 0.0f);
    assert_true(steps.estimate_radiance(below, &hit, vec3(0, 0, 1), &gather).r == 0.0f);
    assert_within(steps.estimate_radiance(both, &hit, vec3(0, 0, 1), &gather).r, one.r, 1e-6, "the upper one alone");
}

TEST(an_empty_map_is_dark)
{
    Hit hit = floor_hit(0, 0);
    Gather gather = {.k = 10, .radius = INFINITY, .near = near};
    PhotonMap *map = map_of(NULL, 0);
    assert_true(colour_sum(steps.estimate_radiance(map, &hit, vec3(0, 0, 1), &gather)) == 0.0f);
}

// Uniform light, E = 1 W/m² from 100000 photons on 1 m²: the mean of many estimates is ρE/π. With k photons
// and the distance to the k-th, as with a fixed radius (k larger than what it holds): the cone that reaches
// just to the k-th is unbiased.
TEST(uniform_photons_give_the_irradiance)
{
    enum { COUNT = 100000, GRID = 24 };
    static StoredPhoton photons[COUNT];
    Rng rng = rng_create(16, 0);
    for (int i = 0; i < COUNT; i++) {
        float x = rng_float(&rng), y = rng_float(&rng);
        photons[i] = photon_on_floor(x, y, tilted(60.0 * (double)rng_float(&rng)), 1.0f / COUNT);
    }
    PhotonMap *map = map_of(photons, COUNT);
    const Gather gathers[3] = {{.k = 20, .radius = INFINITY, .near = near},
                               {.k = 100, .radius = INFINITY, .near = near},
                               {.k = ROOM, .radius = 0.02f, .near = near}}; // holds 126 on average
    for (int g = 0; g < 3; g++) {
        Mean mean = {0};
        for (int i = 0; i < GRID * GRID; i++) {
            Gather gather = gathers[g];
            float step = 0.92f / GRID; // apart by more than two radii: each photon counts once
            Hit hit = floor_hit(0.05f + step * (float)(i / GRID), 0.05f + step * (float)(i % GRID));
            mean_add(&mean, steps.estimate_radiance(map, &hit, vec3(0, 0, 1), &gather).r);
        }
        assert_mean(&mean, 0.5 / M_PI, "mean radiance");
    }
}

AROUND_TESTS(load_reference_steps, NULL)
