// Photons on a floor whose irradiance is known: what the figures of the estimate's error are measured with.
#pragma once

#include "photonlab.h"

#include <stdio.h>
#include <stdlib.h>

// Irradiance (W/m²) at a place on the floor, at most 1.
typedef double (*Irradiance)(double x, double y);

static inline void give_up(const char *why)
{
    fprintf(stderr, "%s\n", why);
    exit(1);
}

// Photons over low ≤ x, y < high, `per_metre2` of them where the irradiance is 1 (Poisson: the rest is left out by
// chance), each of power 1/per_metre2 and from straight above.
static inline PhotonMap *plane_map(double per_metre2, double low, double high, Irradiance irradiance, Rng *rng)
{
    double side = high - low;
    size_t tries = (size_t)(per_metre2 * side * side);
    StoredPhoton *photons = malloc((tries + 1) * sizeof *photons);
    Error error = {{0}};
    size_t kept = 0;
    for (size_t i = 0; photons && i < tries; i++) {
        double x = low + side * (double)rng_float(rng);
        double y = low + side * (double)rng_float(rng);
        if ((double)rng_float(rng) >= irradiance(x, y))
            continue;
        photons[kept++] = (StoredPhoton){.position = vec3((float)x, (float)y, 0.0f),
                                         .power = colour_grey((float)(1.0 / per_metre2)),
                                         .packed_wi = direction_pack(vec3(0, 0, 1))};
    }
    PhotonMap *map = photons ? photon_map_build(photons, kept, &error) : NULL;
    if (!map)
        give_up("no memory for the photons");
    return map;
}

// The irradiance that step 1.6 finds there: π/ρ times its radiance.
static inline double plane_estimate(const PhotonMap *map, double x, double y, Gather *gather)
{
    static Material white = {.type = MATERIAL_DIFFUSE, .diffuse = {1.0f, 1.0f, 1.0f}};
    Hit hit = {.position = vec3((float)x, (float)y, 0.0f), .normal = vec3(0, 0, 1), .material = &white};
    return (double)(PI * steps.estimate_radiance(map, &hit, vec3(0, 0, 1), gather).r);
}
