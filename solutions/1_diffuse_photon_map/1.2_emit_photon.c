// Step 1.2: emit a photon from a rectangular light. Contract: lib/steps/1_diffuse_photon_map.h
#include "photonlab.h"

Photon emit_photon(const Light *light, Rng *rng)
{
    // BEGIN SOLUTION
    // 1. Pick a uniform point on the rectangle: a random share of each side.
    float u = rng_float(rng);
    float v = rng_float(rng);
    Vec3 position = vec3_along(vec3_along(light->position, light->edge_u, u), light->edge_v, v);

    // 2. Pick a direction: a Lambertian light shines with the cosine, as a diffuse surface reflects.
    Vec3 direction = steps.scatter_diffuse(light->direction, rng);

    // 3. Give the photon the light's whole power.
    return photon_create(position, direction, light->power);
    // STUB: return photon_create(light->position, light->direction, light->power);
    // END SOLUTION
}
