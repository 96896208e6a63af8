#include "photonlab.h"

// Snell and Fresnel written out, without the steps of stage 3.
static Vec3 at_glass(Vec3 d, Vec3 n, float eta, float u)
{
    float ci = -vec3_dot(d, n), s2 = eta * eta * (1.0f - ci * ci);
    Vec3 back = vec3_along(d, n, 2.0f * ci);
    if (s2 >= 1.0f)
        return back;
    float ct = sqrtf(1.0f - s2);
    float rs = (eta * ci - ct) / (eta * ci + ct), rp = (ci - eta * ct) / (ci + eta * ct);
    if (u < 0.5f * (rs * rs + rp * rp))
        return back;
    return vec3_normalize(vec3_along(vec3_scale(d, eta), n, eta * ci - ct));
}

void trace_photon_at_wavelength(PhotonTrace *trace, Photon photon, Rng *rng)
{
    for (Hit hit; photon_fly(trace, &photon, &hit); photon.position = hit.position) {
        Material at = photon_surface(&photon, &hit);
        bool lives = true;
        if (at.type == MATERIAL_GLASS) {
            float n = steps.index_at_wavelength(hit.material, photon.wavelength);
            float u = rng_float(rng);
            photon.direction = at_glass(photon.direction, hit.normal, hit.entering ? 1.0f / n : n, u);
        } else if (at.type == MATERIAL_MIRROR) {
            lives = steps.russian_roulette(&photon.power, at.specular, rng);
            photon.direction = steps.reflect(photon.direction, hit.normal);
        } else if (at.type == MATERIAL_DIFFUSE) {
            photon_store(trace, &photon, &hit);
            lives = steps.russian_roulette(&photon.power, at.diffuse, rng);
            if (lives)
                photon.direction = steps.scatter_diffuse(hit.normal, rng);
        } else if (at.type == MATERIAL_GLOSSY) {
            photon_store(trace, &photon, &hit);
            lives = photon_scatter_glossy(&photon, &hit, rng);
        } else
            lives = false;
        if (!lives)
            return;
    }
}
