#include "photonlab.h"

// As step 3.4 is built: one flight, then itself.
void trace_photon_at_wavelength(PhotonTrace *trace, Photon photon, Rng *rng)
{
    Hit hit;
    if (!photon_fly(trace, &photon, &hit))
        return;
    const Material surface = photon_surface(&photon, &hit);
    if (material_is_rough(&surface))
        photon_store(trace, &photon, &hit);
    if (surface.type == MATERIAL_LIGHT)
        return;
    if (surface.type == MATERIAL_DIFFUSE) {
        if (!steps.russian_roulette(&photon.power, surface.diffuse, rng))
            return;
        photon.direction = steps.scatter_diffuse(hit.normal, rng);
    } else if (surface.type == MATERIAL_MIRROR) {
        if (!steps.russian_roulette(&photon.power, surface.specular, rng))
            return;
        photon.direction = steps.reflect(photon.direction, hit.normal);
    } else if (surface.type == MATERIAL_GLOSSY) {
        if (!photon_scatter_glossy(&photon, &hit, rng))
            return;
    } else {
        float eta = glass_eta(&hit, steps.index_at_wavelength(hit.material, photon.wavelength));
        float cos_i = -vec3_dot(photon.direction, hit.normal);
        float back = steps.fresnel(cos_i, eta);
        Vec3 through;
        if (rng_float(rng) < back || !steps.refract(photon.direction, hit.normal, eta, &through))
            through = steps.reflect(photon.direction, hit.normal);
        photon.direction = through;
    }
    photon.position = hit.position;
    trace_photon_at_wavelength(trace, photon, rng);
}
