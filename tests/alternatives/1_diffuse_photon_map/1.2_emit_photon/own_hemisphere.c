// Calls no other step: a disk lifted to the hemisphere, in the frame of the light's own sides.
#include "photonlab.h"

static Vec3 lift(Vec3 normal, Vec3 side, Rng *rng)
{
    float x, y, r2;
    do {
        x = 2.0f * rng_float(rng) - 1.0f;
        y = 2.0f * rng_float(rng) - 1.0f;
        r2 = x * x + y * y;
    } while (r2 >= 1.0f);
    Vec3 tangent = vec3_normalize(side);
    Vec3 bitangent = vec3_cross(normal, tangent);
    Vec3 d = vec3_along(vec3_scale(tangent, x), bitangent, y);
    return vec3_along(d, normal, sqrtf(1.0f - r2));
}

Photon emit_photon(const Light *light, Rng *rng)
{
    float b = rng_float(rng);
    float a = rng_float(rng);
    Vec3 where = light->position;
    where = vec3_add(where, vec3_scale(light->edge_v, b));
    where = vec3_add(where, vec3_scale(light->edge_u, a));
    return photon_create(where, lift(light->direction, light->edge_u, rng), light->power);
}
