// Step 1.5: the life of a photon, as a loop. Contract: lib/steps/1_diffuse_photon_map.h
#include "photonlab.h"

void trace_photon(PhotonTrace *trace, Photon photon, Rng *rng)
{
    // BEGIN SOLUTION
    Hit hit;

    // 1. Fly from surface to surface until the path ends.
    while (photon_fly(trace, &photon, &hit)) {
        const Material *material = hit.material;

        // 2. Leave a copy where it lands on a rough surface, with the power it arrives with.
        if (material_is_rough(material))
            photon_store(trace, &photon, &hit);

        // 3. Do what the material does: survive and take a new direction, or end here.
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
            photon_scatter_glass(&photon, &hit, rng);
            break;
        case MATERIAL_LIGHT:
            return;
        }

        // 4. Fly on from here.
        photon.position = hit.position;
    }
    // END SOLUTION
}
