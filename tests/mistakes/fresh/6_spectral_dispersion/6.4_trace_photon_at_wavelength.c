//1 always_entering          the index of the way in
//2 stored_on_glass          stored everywhere
//3 index_of_white           the three colours' mean
//4 surface_in_rgb           colours in place of wavelengths
//5 walls_keep_all           no roulette
//6 -                        reflected with half the probability
#include "photonlab.h"
void trace_photon_at_wavelength(PhotonTrace *T, Photon p, Rng *rng)
{
    Hit h;
    if (!photon_fly(T, &p, &h))
        return;
    Material m = MISTAKE == 4 ? *h.material : photon_surface(&p, &h);
    p.position = h.position;
    if (material_is_rough(&m) || (MISTAKE == 2 && m.type != MATERIAL_LIGHT))
        photon_store(T, &p, &h);
    if (m.type == MATERIAL_DIFFUSE) {
        if (MISTAKE != 5 && !steps.russian_roulette(&p.power, m.diffuse, rng))
            return;
        p.direction = steps.scatter_diffuse(h.normal, rng);
    } else if (m.type == MATERIAL_GLOSSY) {
        if (!photon_scatter_glossy(&p, &h, rng))
            return;
    } else if (m.type == MATERIAL_MIRROR) {
        if (!steps.russian_roulette(&p.power, m.specular, rng))
            return;
        p.direction = steps.reflect(p.direction, h.normal);
    } else if (m.type == MATERIAL_GLASS) {
        float n = MISTAKE == 3 ? steps.refractive_index(h.material, WHITE)
                               : steps.index_at_wavelength(h.material, p.wavelength);
        float eta = MISTAKE == 1 ? 1.0f / n : glass_eta(&h, n),
              F = steps.fresnel(-vec3_dot(p.direction, h.normal), eta);
        Vec3 t;
        bool back = rng_float(rng) < (MISTAKE == 6 && F < 1.0f ? 0.5f * F : F) ||
                    !steps.refract(p.direction, h.normal, eta, &t);
        p.direction = back ? steps.reflect(p.direction, h.normal) : t;
    } else {
        return;
    }
    steps.trace_photon_at_wavelength(T, p, rng);
}
