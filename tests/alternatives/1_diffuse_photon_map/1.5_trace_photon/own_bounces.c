// Calls no other step: mirror, roulette and diffuse bounce written out.
#include "photonlab.h"

static bool survive(Photon *photon, Colour share, Rng *rng)
{
    Colour after = colour_mul(photon->power, share);
    float p = colour_sum(after) / colour_sum(photon->power);
    if (!(rng_float(rng) < p))
        return false;
    photon->power = colour_scale(after, 1.0f / fminf(p, 1.0f));
    return true;
}

static Vec3 cosine_about(Vec3 n, Rng *rng)
{
    float phi = 2.0f * PI * rng_float(rng);
    float sin2 = rng_float(rng);
    float r = sqrtf(sin2);
    Frame frame = frame_about(n);
    return frame_to_world(&frame, vec3(r * cosf(phi), r * sinf(phi), sqrtf(1.0f - sin2)));
}

void trace_photon(PhotonTrace *trace, Photon photon, Rng *rng)
{
    for (Hit hit; photon_fly(trace, &photon, &hit); photon.position = hit.position) {
        const Material *m = hit.material;
        if (m->type == MATERIAL_GLASS) {
            photon_scatter_glass(&photon, &hit, rng);
            continue;
        }
        if (m->type == MATERIAL_MIRROR) {
            if (!survive(&photon, m->specular, rng))
                break;
            float along = vec3_dot(photon.direction, hit.normal);
            photon.direction = vec3_along(photon.direction, hit.normal, -2.0f * along);
            continue;
        }
        photon_store(trace, &photon, &hit);
        if (m->type == MATERIAL_GLOSSY ? !photon_scatter_glossy(&photon, &hit, rng)
                                       : !survive(&photon, m->diffuse, rng))
            break;
        if (m->type == MATERIAL_DIFFUSE)
            photon.direction = cosine_about(hit.normal, rng);
    }
}
