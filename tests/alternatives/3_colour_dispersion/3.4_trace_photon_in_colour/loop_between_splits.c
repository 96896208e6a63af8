// A loop; it calls itself only for the children of a split.
#include "photonlab.h"

// Shares of the power that a photon keeps, divided by the probability. True: it reflects.
static bool reflects(Photon *photon, const Hit *hit, Rng *rng)
{
    double f[3], mean = 0.0;
    float cos_i = -vec3_dot(photon->direction, hit->normal);
    for (int c = 0; c < 3; c++) {
        PhotonColour band = photon->colour != WHITE ? photon->colour : c == 0 ? RED : c == 1 ? GREEN : BLUE;
        f[c] = (double)steps.fresnel(cos_i, glass_eta(hit, steps.refractive_index(hit->material, band)));
        mean += f[c];
    }
    mean /= 3.0;
    bool reflected = (double)rng_float(rng) < mean;
    for (int c = 0; c < 3; c++) {
        double gain = reflected ? f[c] / mean : (1.0 - f[c]) / (1.0 - mean);
        colour_set_channel(&photon->power, c, (float)(gain * (double)colour_channel(photon->power, c)));
    }
    return reflected;
}

void trace_photon_in_colour(PhotonTrace *trace, Photon photon, Rng *rng)
{
    for (Hit hit; photon_fly(trace, &photon, &hit);) {
        const Material *m = hit.material;
        photon.position = hit.position;
        if (m->type == MATERIAL_DIFFUSE) {
            photon_store(trace, &photon, &hit);
            if (!steps.russian_roulette(&photon.power, m->diffuse, rng))
                return;
            photon.direction = steps.scatter_diffuse(hit.normal, rng);
        } else if (m->type == MATERIAL_GLOSSY) {
            photon_store(trace, &photon, &hit);
            if (!photon_scatter_glossy(&photon, &hit, rng))
                return;
        } else if (m->type == MATERIAL_MIRROR) {
            if (!steps.russian_roulette(&photon.power, m->specular, rng))
                return;
            photon.direction = steps.reflect(photon.direction, hit.normal);
        } else if (reflects(&photon, &hit, rng)) {
            photon.direction = steps.reflect(photon.direction, hit.normal);
        } else {
            Photon children[3];
            int count = steps.split_colour(&photon, m, children);
            for (int i = 0; i < count; i++) {
                float eta = glass_eta(&hit, steps.refractive_index(m, children[i].colour));
                if (colour_sum(children[i].power) <= 0.0f)
                    continue;
                if (steps.refract(photon.direction, hit.normal, eta, &children[i].direction))
                    steps.trace_photon_in_colour(trace, children[i], rng);
            }
            return;
        }
    }
}
