// White and coloured photons meet glass in a function each; a coloured one has no weights.
#include "photonlab.h"

static void go_on(PhotonTrace *trace, Photon photon, Vec3 direction, Rng *rng)
{
    photon.direction = direction;
    steps.trace_photon_in_colour(trace, photon, rng);
}

static void coloured_meets_glass(PhotonTrace *trace, Photon photon, const Hit *hit, Rng *rng)
{
    float eta = glass_eta(hit, steps.refractive_index(hit->material, photon.colour));
    float reflected = steps.fresnel(-vec3_dot(hit->normal, photon.direction), eta);
    Vec3 through;
    if (rng_float(rng) >= reflected && steps.refract(photon.direction, hit->normal, eta, &through))
        go_on(trace, photon, through, rng);
    else
        go_on(trace, photon, steps.reflect(photon.direction, hit->normal), rng);
}

static void white_meets_glass(PhotonTrace *trace, Photon photon, const Hit *hit, Rng *rng)
{
    float eta[3], f[3];
    float mean = 0.0f;
    for (int c = 0; c < 3; c++) {
        eta[c] = glass_eta(hit, steps.refractive_index(hit->material, (PhotonColour)(c + RED)));
        f[c] = steps.fresnel(-vec3_dot(hit->normal, photon.direction), eta[c]);
        mean += f[c] / 3.0f;
    }
    if (rng_float(rng) < mean) {
        photon.power = colour_mul(photon.power, colour(f[0] / mean, f[1] / mean, f[2] / mean));
        go_on(trace, photon, steps.reflect(photon.direction, hit->normal), rng);
        return;
    }
    Photon children[3];
    int count = steps.split_colour(&photon, hit->material, children);
    for (int i = 0; i < count; i++) {
        Photon child = children[i];
        int own = child.colour == WHITE ? 0 : (int)child.colour - RED;
        Vec3 through;
        child.power = colour_mul(child.power, colour((1.0f - f[0]) / (1.0f - mean), (1.0f - f[1]) / (1.0f - mean),
                                                     (1.0f - f[2]) / (1.0f - mean)));
        if (colour_sum(child.power) > 0.0f && steps.refract(photon.direction, hit->normal, eta[own], &through))
            go_on(trace, child, through, rng);
    }
}

void trace_photon_in_colour(PhotonTrace *trace, Photon photon, Rng *rng)
{
    Hit hit;
    if (!photon_fly(trace, &photon, &hit))
        return;
    photon.position = hit.position;
    const Material *m = hit.material;
    if (m->type == MATERIAL_GLASS && photon.colour == WHITE) {
        white_meets_glass(trace, photon, &hit, rng);
    } else if (m->type == MATERIAL_GLASS) {
        coloured_meets_glass(trace, photon, &hit, rng);
    } else if (m->type == MATERIAL_MIRROR) {
        if (steps.russian_roulette(&photon.power, m->specular, rng))
            go_on(trace, photon, steps.reflect(photon.direction, hit.normal), rng);
    } else if (m->type == MATERIAL_GLOSSY) {
        photon_store(trace, &photon, &hit);
        if (photon_scatter_glossy(&photon, &hit, rng))
            go_on(trace, photon, photon.direction, rng);
    } else if (m->type == MATERIAL_DIFFUSE) {
        photon_store(trace, &photon, &hit);
        if (steps.russian_roulette(&photon.power, m->diffuse, rng))
            go_on(trace, photon, steps.scatter_diffuse(hit.normal, rng), rng);
    }
}
