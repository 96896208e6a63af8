// Step 1.2: emit a photon from a rectangular light. Contract: lib/steps/1_diffuse_photon_map.h
#include "photonlab.h"

Photon emit_photon(const Light *light, Rng *rng)
{
    todo("1.2"), (void)rng; // take this line away when you start

    // 1. Pick a uniform point on the rectangle: a random share of each side.

    // 2. Pick a direction: a Lambertian light shines with the cosine, as a diffuse surface reflects.

    // 3. Give the photon the light's whole power.

    return photon_create(light->position, light->direction, light->power);
}
