// Step 6.4: the life of a photon of one wavelength. Contract: lib/steps/6_spectral_dispersion.h
#include "photonlab.h"

// Glass: reflected or refracted, at the photon's own index. Whole, as nothing splits.
static Vec3 turn_at_glass(const Photon *photon, const Hit *hit, Rng *rng)
{
    // BEGIN SOLUTION
    // 4. The index of its one wavelength, on the way in as on the way out.
    float eta = glass_eta(hit, steps.index_at_wavelength(hit->material, photon->wavelength));
    float share = steps.fresnel(-vec3_dot(photon->direction, hit->normal), eta);

    // 5. Through, or back. Its power stays: each way is taken as often as it should be.
    Vec3 through;
    if (rng_float(rng) >= share && steps.refract(photon->direction, hit->normal, eta, &through))
        return through;
    return steps.reflect(photon->direction, hit->normal);
    // STUB: return photon->direction;
    // END SOLUTION
}

void trace_photon_at_wavelength(PhotonTrace *trace, Photon photon, Rng *rng)
{
    // BEGIN SOLUTION
    Hit hit;

    // 1. Fly from surface to surface. What each is at this wavelength?
    while (photon_fly(trace, &photon, &hit)) {
        Material here = photon_surface(&photon, &hit);

        // 2. Leave a copy on a rough surface.
        if (material_is_rough(&here))
            photon_store(trace, &photon, &hit);

        // 3. Do what the material does, as in 1.5 or 3.4, but with the reflectances at this wavelength.
        switch (here.type) {
        case MATERIAL_DIFFUSE:
            if (!steps.russian_roulette(&photon.power, here.diffuse, rng))
                return;
            photon.direction = steps.scatter_diffuse(hit.normal, rng);
            break;
        case MATERIAL_GLOSSY:
            if (!photon_scatter_glossy(&photon, &hit, rng))
                return;
            break;
        case MATERIAL_MIRROR:
            if (!steps.russian_roulette(&photon.power, here.specular, rng))
                return;
            photon.direction = steps.reflect(photon.direction, hit.normal);
            break;
        case MATERIAL_GLASS:
            photon.direction = turn_at_glass(&photon, &hit, rng);
            break;
        case MATERIAL_LIGHT:
            return;
        }

        // 6. Fly on from here.
        photon.position = hit.position;
    }
    // END SOLUTION
}
