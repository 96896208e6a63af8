// No recursion: children wait in a list. A photon splits once, so three places are enough.
#include "photonlab.h"

typedef struct {
    Photon photons[4];
    int count;
} Waiting;

static void meet_glass(Waiting *waiting, Photon photon, const Hit *hit, Rng *rng)
{
    const Material *glass = hit->material;
    float f[3];
    for (int c = 0; c < 3; c++) {
        float index = steps.refractive_index(glass, photon.colour == WHITE ? (PhotonColour)(c + 1) : photon.colour);
        f[c] = steps.fresnel(fabsf(vec3_dot(hit->normal, photon.direction)), glass_eta(hit, index));
    }
    float mean = (f[0] + f[1] + f[2]) / 3.0f;
    bool reflects = rng_float(rng) < mean;
    float chance = reflects ? mean : 1.0f - mean;
    photon.power.r *= (reflects ? f[0] : 1.0f - f[0]) / chance;
    photon.power.g *= (reflects ? f[1] : 1.0f - f[1]) / chance;
    photon.power.b *= (reflects ? f[2] : 1.0f - f[2]) / chance;
    if (reflects) {
        photon.direction = steps.reflect(photon.direction, hit->normal);
        waiting->photons[waiting->count++] = photon;
        return;
    }
    Photon children[3];
    int count = steps.split_colour(&photon, glass, children);
    for (int i = count - 1; i >= 0; i--) {
        float eta = glass_eta(hit, steps.refractive_index(glass, children[i].colour));
        bool through = steps.refract(photon.direction, hit->normal, eta, &children[i].direction);
        if (through && colour_sum(children[i].power) > 0.0f)
            waiting->photons[waiting->count++] = children[i];
    }
}

// Rough surfaces and mirrors. False: absorbed.
static bool bounce(Photon *photon, const Hit *hit, Rng *rng)
{
    const Material *m = hit->material;
    if (m->type == MATERIAL_GLOSSY)
        return photon_scatter_glossy(photon, hit, rng);
    if (m->type == MATERIAL_MIRROR) {
        photon->direction = steps.reflect(photon->direction, hit->normal);
        return steps.russian_roulette(&photon->power, m->specular, rng);
    }
    photon->direction = steps.scatter_diffuse(hit->normal, rng);
    return m->type == MATERIAL_DIFFUSE && steps.russian_roulette(&photon->power, m->diffuse, rng);
}

void trace_photon_in_colour(PhotonTrace *trace, Photon photon, Rng *rng)
{
    Waiting waiting = {.photons = {photon}, .count = 1};
    while (waiting.count > 0) {
        Photon next = waiting.photons[--waiting.count];
        Hit hit;
        if (!photon_fly(trace, &next, &hit))
            continue;
        if (material_is_rough(hit.material))
            photon_store(trace, &next, &hit);
        next.position = hit.position;
        if (hit.material->type == MATERIAL_GLASS)
            meet_glass(&waiting, next, &hit, rng);
        else if (bounce(&next, &hit, rng))
            waiting.photons[waiting.count++] = next;
    }
}
