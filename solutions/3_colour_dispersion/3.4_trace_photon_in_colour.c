// Step 3.4: the life of a photon, as a recursion that carries its colour. Contract: lib/steps/3_colour_dispersion.h
#include "photonlab.h"

// Glass: the photon flies on reflected, or refracted and perhaps split.
static void meet_glass(PhotonTrace *trace, Photon photon, const Hit *hit, Rng *rng)
{
    // BEGIN SOLUTION
    const Material *glass = hit->material;
    float cos_i = -vec3_dot(photon.direction, hit->normal);

    // 4. Find the share that each channel reflects. White light has three indices, a coloured photon its own.
    float share[3];
    for (int c = 0; c < 3; c++) {
        PhotonColour band = photon.colour == WHITE ? (PhotonColour)(RED + c) : photon.colour;
        share[c] = steps.fresnel(cos_i, glass_eta(hit, steps.refractive_index(glass, band)));
    }
    float mean = (share[0] + share[1] + share[2]) / 3.0f;

    // 5. Reflect with the mean probability. Weights make up for the channels that would have had another. White stays
    // white.
    if (rng_float(rng) < mean) {
        photon.power = colour_mul(photon.power, colour(share[0] / mean, share[1] / mean, share[2] / mean));
        photon.direction = steps.reflect(photon.direction, hit->normal);
        steps.trace_photon_in_colour(trace, photon, rng);
        return;
    }
    float rest = 1.0f - mean;
    photon.power =
        colour_mul(photon.power, colour((1.0f - share[0]) / rest, (1.0f - share[1]) / rest, (1.0f - share[2]) / rest));

    // 6. Otherwise refract: split white into its colours and follow each on its own way.
    Photon children[3];
    int count = steps.split_colour(&photon, glass, children);
    for (int i = 0; i < count; i++) {
        float eta = glass_eta(hit, steps.refractive_index(glass, children[i].colour));
        if (colour_sum(children[i].power) > 0.0f &&
            steps.refract(photon.direction, hit->normal, eta, &children[i].direction))
            steps.trace_photon_in_colour(trace, children[i], rng);
    }
    // END SOLUTION
}

void trace_photon_in_colour(PhotonTrace *trace, Photon photon, Rng *rng)
{
    // BEGIN SOLUTION
    // 1. Fly to the next surface; the recursion ends where the path does.
    Hit hit;
    if (!photon_fly(trace, &photon, &hit))
        return;
    const Material *material = hit.material;
    photon.position = hit.position;

    // 2. Leave a copy on a rough surface.
    if (material_is_rough(material))
        photon_store(trace, &photon, &hit);

    // 3. Do what the material does, as in the loop of step 1.5: your code there will do here.
    switch (material->type) {
    case MATERIAL_DIFFUSE:
        if (!steps.russian_roulette(&photon.power, material->diffuse, rng))
            return;
        photon.direction = steps.scatter_diffuse(hit.normal, rng);
        break;
    case MATERIAL_GLOSSY:
        if (!photon_scatter_glossy(&photon, &hit, rng))
            return;
        break;
    case MATERIAL_MIRROR:
        if (!steps.russian_roulette(&photon.power, material->specular, rng))
            return;
        photon.direction = steps.reflect(photon.direction, hit.normal);
        break;
    case MATERIAL_GLASS:
        meet_glass(trace, photon, &hit, rng);
        return;
    case MATERIAL_LIGHT:
        return;
    }
    steps.trace_photon_in_colour(trace, photon, rng);
    // END SOLUTION
}
