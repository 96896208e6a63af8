//1 never_splits            white goes on as it is
//2 weights_missing         no weights
//3 shared_index            white's index for all children
//4 colour_forgotten        the children are white again
//5 never_reflects          no Fresnel
//6 diffuse_ends            stored and forgotten
//7 -                       the children get half of what they should
#include "photonlab.h"
void trace_photon_in_colour(PhotonTrace *T, Photon p, Rng *rng)
{
    Hit h;
    if (!photon_fly(T, &p, &h))
        return;
    const Material *m = h.material;
    p.position = h.position;
    if (m->type == MATERIAL_LIGHT)
        return;
    if (m->type == MATERIAL_DIFFUSE || m->type == MATERIAL_GLOSSY)
        photon_store(T, &p, &h);
    if (m->type == MATERIAL_DIFFUSE) {
        if (MISTAKE == 6 || !steps.russian_roulette(&p.power, m->diffuse, rng))
            return;
        p.direction = steps.scatter_diffuse(h.normal, rng);
    } else if (m->type == MATERIAL_GLOSSY) {
        if (!photon_scatter_glossy(&p, &h, rng))
            return;
    } else if (m->type == MATERIAL_MIRROR) {
        if (!steps.russian_roulette(&p.power, m->specular, rng))
            return;
        p.direction = steps.reflect(p.direction, h.normal);
    } else {
        float F[3], f = 0.0f, mu = -vec3_dot(p.direction, h.normal);
        for (int i = 0; i < 3; i++) {
            PhotonColour c = p.colour == WHITE ? (PhotonColour)(i + RED) : p.colour;
            F[i] = steps.fresnel(mu, glass_eta(&h, steps.refractive_index(m, c)));
            f += F[i] / 3.0f;
        }
        bool back = rng_float(rng) < f && MISTAKE != 5;
        if (MISTAKE != 2)
            for (int i = 0; i < 3; i++)
                colour_set_channel(&p.power, i,
                                   colour_channel(p.power, i) * (back           ? F[i] / f
                                                                 : MISTAKE == 5 ? 1.0f
                                                                                : (1.0f - F[i]) / (1.0f - f)));
        if (back) {
            p.direction = steps.reflect(p.direction, h.normal);
            steps.trace_photon_in_colour(T, p, rng);
            return;
        }
        Photon kids[3] = {p};
        int n = MISTAKE == 1 ? 1 : steps.split_colour(&p, m, kids);
        while (n-- > 0) {
            Photon k = kids[n];
            if (colour_sum(k.power) <= 0.0f ||
                !steps.refract(p.direction, h.normal,
                               glass_eta(&h, steps.refractive_index(m, MISTAKE == 3 ? p.colour : k.colour)),
                               &k.direction))
                continue;
            if (MISTAKE == 4)
                k.colour = p.colour;
            if (MISTAKE == 7)
                k.power = colour_scale(k.power, 0.5f);
            steps.trace_photon_in_colour(T, k, rng);
        }
        return;
    }
    steps.trace_photon_in_colour(T, p, rng);
}
