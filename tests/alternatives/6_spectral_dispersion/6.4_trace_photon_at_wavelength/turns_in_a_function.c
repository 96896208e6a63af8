#include "photonlab.h"

// Each material says whether the photon lives, and turns it.
static bool turn(Photon *photon, const Hit *hit, const Material *here, Rng *rng)
{
    if (here->type == MATERIAL_LIGHT)
        return false;
    if (here->type == MATERIAL_GLOSSY)
        return photon_scatter_glossy(photon, hit, rng);
    if (here->type == MATERIAL_DIFFUSE || here->type == MATERIAL_MIRROR) {
        bool rough = here->type == MATERIAL_DIFFUSE;
        if (!steps.russian_roulette(&photon->power, rough ? here->diffuse : here->specular, rng))
            return false;
        photon->direction =
            rough ? steps.scatter_diffuse(hit->normal, rng) : steps.reflect(photon->direction, hit->normal);
        return true;
    }
    float index = steps.index_at_wavelength(here, photon->wavelength);
    float eta = glass_eta(hit, index);
    Vec3 refracted;
    bool through = steps.refract(photon->direction, hit->normal, eta, &refracted);
    if (through && steps.fresnel(-vec3_dot(photon->direction, hit->normal), eta) <= rng_float(rng))
        photon->direction = refracted;
    else
        photon->direction = steps.reflect(photon->direction, hit->normal);
    return true;
}

void trace_photon_at_wavelength(PhotonTrace *trace, Photon photon, Rng *rng)
{
    Hit hit;
    bool flies = photon_fly(trace, &photon, &hit);
    while (flies) {
        Material here = photon_surface(&photon, &hit);
        if (here.type == MATERIAL_DIFFUSE || here.type == MATERIAL_GLOSSY)
            photon_store(trace, &photon, &hit);
        flies = turn(&photon, &hit, &here, rng);
        if (flies) {
            photon.position = hit.position;
            flies = photon_fly(trace, &photon, &hit);
        }
    }
}
