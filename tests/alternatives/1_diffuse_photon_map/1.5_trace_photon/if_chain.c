// One endless loop with ifs, left by return.
#include "photonlab.h"

void trace_photon(PhotonTrace *trace, Photon photon, Rng *rng)
{
    for (;;) {
        Hit hit;
        if (!photon_fly(trace, &photon, &hit))
            return;
        const MaterialType type = hit.material->type;
        if (type == MATERIAL_DIFFUSE || type == MATERIAL_GLOSSY)
            photon_store(trace, &photon, &hit);
        photon.position = hit.position;

        if (type == MATERIAL_DIFFUSE) {
            if (!steps.russian_roulette(&photon.power, hit.material->diffuse, rng))
                return;
            photon.direction = steps.scatter_diffuse(hit.normal, rng);
        } else if (type == MATERIAL_GLOSSY) {
            if (!photon_scatter_glossy(&photon, &hit, rng))
                return;
        } else if (type == MATERIAL_MIRROR) {
            if (!steps.russian_roulette(&photon.power, hit.material->specular, rng))
                return;
            photon.direction = steps.reflect(photon.direction, hit.normal);
        } else if (type == MATERIAL_GLASS) {
            photon_scatter_glass(&photon, &hit, rng);
        } else {
            return;
        }
    }
}
