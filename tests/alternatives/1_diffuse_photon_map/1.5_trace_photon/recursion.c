// The same life as a recursion.
#include "photonlab.h"

static bool bounce(Photon *photon, const Hit *hit, Rng *rng)
{
    const Material *m = hit->material;
    if (m->type == MATERIAL_GLASS) {
        photon_scatter_glass(photon, hit, rng);
        return true;
    }
    if (m->type == MATERIAL_GLOSSY)
        return photon_scatter_glossy(photon, hit, rng);
    bool matt = m->type == MATERIAL_DIFFUSE;
    if (!steps.russian_roulette(&photon->power, matt ? m->diffuse : m->specular, rng))
        return false;
    photon->direction = matt ? steps.scatter_diffuse(hit->normal, rng) : steps.reflect(photon->direction, hit->normal);
    return true;
}

void trace_photon(PhotonTrace *trace, Photon photon, Rng *rng)
{
    Hit hit;
    if (!photon_fly(trace, &photon, &hit))
        return;
    if (material_is_rough(hit.material))
        photon_store(trace, &photon, &hit);
    Photon next = photon;
    next.position = hit.position;
    if (hit.material->type != MATERIAL_LIGHT && bounce(&next, &hit, rng))
        trace_photon(trace, next, rng);
}
