// Direction first, then an offset from the centre; the power worked out anew.
#include "photonlab.h"

Photon emit_photon(const Light *light, Rng *rng)
{
    Vec3 direction = steps.scatter_diffuse(light->direction, rng);
    float across = rng_float(rng) - 0.5f;
    float along = rng_float(rng) - 0.5f;
    Vec3 centre = vec3_add(light->position, vec3_scale(vec3_add(light->edge_u, light->edge_v), 0.5f));
    Vec3 offset = vec3_add(vec3_scale(light->edge_v, across), vec3_scale(light->edge_u, along));
    float area = vec3_length(vec3_cross(light->edge_u, light->edge_v));
    return photon_create(vec3_add(centre, offset), direction, colour_scale(light->radiance, PI * area));
}
