// A flag says whether the photon lives; it is stored inside the cases.
#include "photonlab.h"

void trace_photon(PhotonTrace *trace, Photon photon, Rng *rng)
{
    Hit hit;
    bool alive = photon_fly(trace, &photon, &hit);
    while (alive) {
        const Material *m = hit.material;
        switch (m->type) {
        case MATERIAL_GLASS:
            photon_scatter_glass(&photon, &hit, rng);
            break;
        case MATERIAL_MIRROR:
            alive = steps.russian_roulette(&photon.power, m->specular, rng);
            if (alive)
                photon.direction = steps.reflect(photon.direction, hit.normal);
            break;
        case MATERIAL_GLOSSY:
            photon_store(trace, &photon, &hit);
            alive = photon_scatter_glossy(&photon, &hit, rng);
            break;
        case MATERIAL_DIFFUSE:
            photon_store(trace, &photon, &hit);
            alive = steps.russian_roulette(&photon.power, m->diffuse, rng);
            if (alive)
                photon.direction = steps.scatter_diffuse(hit.normal, rng);
            break;
        case MATERIAL_LIGHT:
            alive = false;
            break;
        }
        photon.position = hit.position;
        alive = alive && photon_fly(trace, &photon, &hit);
    }
}
