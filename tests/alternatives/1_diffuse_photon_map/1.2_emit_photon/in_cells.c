// Picks one of 4 × 4 cells of the light, then a place within it.
#include "photonlab.h"

#define CELLS 4

Photon emit_photon(const Light *light, Rng *rng)
{
    uint32_t cell = rng_u32(rng) >> 28;
    float u = ((float)(cell % CELLS) + rng_float(rng)) / CELLS;
    float v = ((float)(cell / CELLS) + rng_float(rng)) / CELLS;
    Photon photon = photon_create(light->position, light->direction, light->power);
    photon.position = vec3_along(photon.position, light->edge_u, u);
    photon.position = vec3_along(photon.position, light->edge_v, v);
    photon.direction = steps.scatter_diffuse(light->direction, rng);
    return photon;
}
