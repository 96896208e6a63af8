// Step 1.6, the radiance estimate, where light is even. Its values on given photons are checked in tests/steps/.
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

// Uniform light, E = 1 W/m² from 100000 photons on 1 m²: the mean of many estimates is ρE/π. With k photons
// and the distance to the k-th, as with a fixed radius (k larger than what it holds): the cone that reaches
// just to the k-th is unbiased.
TEST(uniform_photons_give_the_irradiance)
{
    enum { COUNT = 100000, GRID = 24 };
    StoredPhoton *photons = malloc(COUNT * sizeof *photons);
    assert_non_null(photons);
    Rng rng = rng_create(16, 0);
    for (int i = 0; i < COUNT; i++) {
        float x = rng_float(&rng), y = rng_float(&rng);
        photons[i] = photon_on_floor(x, y, tilted(60.0 * (double)rng_float(&rng)), 1.0f / COUNT);
    }
    PhotonMap *map = photon_map_build(photons, COUNT, NULL);
    assert_non_null(map);
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
    photon_map_free(map);
}
