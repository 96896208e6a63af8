#include "photonlab.h"

// Flux of one wavelength is one number: the roulette needs no step of its own.
static bool survives(float reflectance, Rng *rng)
{
    return rng_float(rng) < reflectance;
}

void trace_photon_at_wavelength(PhotonTrace *trace, Photon photon, Rng *rng)
{
    Hit hit;
    while (photon_fly(trace, &photon, &hit)) {
        Material here = photon_surface(&photon, &hit);
        if (material_is_rough(&here))
            photon_store(trace, &photon, &hit);
        switch (here.type) {
        case MATERIAL_GLOSSY:
            if (!photon_scatter_glossy(&photon, &hit, rng))
                return;
            break;
        case MATERIAL_DIFFUSE:
            if (!steps.russian_roulette(&photon.power, here.diffuse, rng))
                return;
            photon.direction = steps.scatter_diffuse(hit.normal, rng);
            break;
        case MATERIAL_MIRROR:
            if (!survives(here.specular.r, rng))
                return;
            photon.direction = steps.reflect(photon.direction, hit.normal);
            break;
        case MATERIAL_GLASS: {
            float eta = glass_eta(&hit, steps.index_at_wavelength(hit.material, photon.wavelength));
            Vec3 out = steps.reflect(photon.direction, hit.normal);
            if (!survives(steps.fresnel(-vec3_dot(photon.direction, hit.normal), eta), rng))
                steps.refract(photon.direction, hit.normal, eta, &out);
            photon.direction = out;
            break;
        }
        case MATERIAL_LIGHT:
            return;
        }
        photon.position = hit.position;
    }
}
