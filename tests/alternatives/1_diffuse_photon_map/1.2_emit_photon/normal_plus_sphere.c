// The normal plus a point of the unit sphere has the cosine's density, once normalised.
#include "photonlab.h"

static Vec3 on_sphere(Rng *rng)
{
    float z = 2.0f * rng_float(rng) - 1.0f;
    float turn = 2.0f * PI * rng_float(rng);
    float r = sqrtf(1.0f - z * z);
    return vec3(r * cosf(turn), r * sinf(turn), z);
}

Photon emit_photon(const Light *light, Rng *rng)
{
    Photon photon;
    Vec3 sum;
    do {
        sum = vec3_add(light->direction, on_sphere(rng));
    } while (vec3_dot(sum, sum) < 1e-6f);
    float s = rng_float(rng);
    float t = rng_float(rng);
    Vec3 start = vec3(light->position.x + s * light->edge_u.x + t * light->edge_v.x,
                      light->position.y + s * light->edge_u.y + t * light->edge_v.y,
                      light->position.z + s * light->edge_u.z + t * light->edge_v.z);
    photon = photon_create(start, vec3_normalize(sum), light->power);
    return photon;
}
