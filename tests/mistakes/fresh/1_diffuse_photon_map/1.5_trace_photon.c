//1 glossy_not_stored       stored on matt surfaces alone
//2 stored_after_roulette   stored with what survives
//3 direct_not_stored       not before the first bounce
//4 glass_absorbs           ends at glass
//5 mirror_without_roulette mirrors keep all
//6 one_bounce              leaves the loop
//7 stored_on_specular      stored everywhere
//8 -                       starts anew at the light's place after glass alone
#include "photonlab.h"
void trace_photon(PhotonTrace *T, Photon ph, Rng *rng)
{
    Hit h;
    int met = 0;
    for (bool alive = true; alive && photon_fly(T, &ph, &h);) {
        const Material *m = h.material;
        bool keep = MISTAKE == 1   ? m->type == MATERIAL_DIFFUSE
                    : MISTAKE == 7 ? m->type != MATERIAL_LIGHT
                                   : material_is_rough(m);
        if (keep && MISTAKE != 2 && !(MISTAKE == 3 && met == 0))
            photon_store(T, &ph, &h);
        if (m->type == MATERIAL_LIGHT) {
            alive = false;
        } else if (m->type == MATERIAL_DIFFUSE) {
            alive = steps.russian_roulette(&ph.power, m->diffuse, rng);
            if (alive && MISTAKE == 2)
                photon_store(T, &ph, &h);
            if (alive)
                ph.direction = steps.scatter_diffuse(h.normal, rng);
        } else if (m->type == MATERIAL_GLOSSY) {
            if (MISTAKE == 2)
                photon_store(T, &ph, &h);
            alive = photon_scatter_glossy(&ph, &h, rng);
        } else if (m->type == MATERIAL_MIRROR) {
            alive = MISTAKE == 5 || steps.russian_roulette(&ph.power, m->specular, rng);
            if (alive)
                ph.direction = steps.reflect(ph.direction, h.normal);
        } else {
            if (MISTAKE == 4)
                return;
            photon_scatter_glass(&ph, &h, rng);
        }
        if (!(MISTAKE == 8 && m->type == MATERIAL_GLASS && met == 0))
            ph.position = h.position;
        met++;
        if (MISTAKE == 6)
            break;
    }
}
