// Photons arranged in ways that have broken kd-trees, for the tests of the photon map.
#pragma once

#include "math/rng.h"
#include "photons/photon_map.h"
#include "unit/test.h"

typedef enum { CUBE, PLANE, LINE, ONE_PLACE, CLUSTERS, LATTICE, ARRANGEMENTS } Arrangement;

static inline Vec3 place(Arrangement arrangement, Rng *rng)
{
    float x = 2.0f * rng_float(rng) - 1.0f;
    float y = 2.0f * rng_float(rng) - 1.0f;
    float z = 2.0f * rng_float(rng) - 1.0f;
    switch (arrangement) {
    case PLANE:
        return vec3(x, -0.5f, z);
    case LINE:
        return vec3(x, x, 0.25f);
    case ONE_PLACE:
        return vec3(0.25f, -0.5f, 0.125f);
    case CLUSTERS: // most in one tiny spot, the others far apart
        return rng_u32(rng) % 8 ? vec3(0.3f + 1e-4f * x, 0.3f + 1e-4f * y, 0.3f) : vec3(50.0f * x, y, z);
    case LATTICE: // many at the same distance, many at the same place
        return vec3(floorf(3.0f * x), floorf(3.0f * y), 0.0f);
    default:
        return vec3(x, y, z);
    }
}

// Each photon carries its number as power, to be known again.
static inline StoredPhoton *make_photons(Arrangement arrangement, size_t count, uint64_t seed)
{
    StoredPhoton *photons = calloc(count ? count : 1, sizeof *photons);
    assert_non_null(photons);
    Rng rng = rng_create(seed, (uint64_t)arrangement);
    for (size_t i = 0; i < count; i++) {
        photons[i].position = place(arrangement, &rng);
        photons[i].power = colour((float)i, 1.0f, 2.0f);
    }
    return photons;
}

FREED_AT_END(own_map, PhotonMap, photon_map_free)

static inline PhotonMap *make_map(Arrangement arrangement, size_t count, uint64_t seed)
{
    PhotonMap *map = photon_map_build(make_photons(arrangement, count, seed), count, &said);
    assert_non_null(map);
    assert_string_equal(said.message, "");
    return own_map(map);
}
