//1 cosine_missing             the fraction alone
//2 not_divided_by_density     BRDF times cosine
//3 not_absorbed|flipped_up    what goes below goes on
//4 normalisation_for_weight   (n+2)/2π times the cosine
//5 weight_inverted            (n+1)/(n+2)
//6 lobe_alone                 the cosine to the mirror direction, to the n
//7 -                          the root of the fraction
//11 redrawn                    drawn again
//12 cosine_of_arrival          the cosine of the arriving light
//13 factor                     a third of it
#include "photonlab.h"
bool scatter_glossy_phong(Vec3 d, Vec3 n, float e, Rng *rng, Vec3 *out, float *weight)
{
    const Vec3 m = steps.reflect(d, n);
    *out = steps.turn_to(steps.sample_lobe(e, rng), m);
    float mu = out->x * n.x + out->y * n.y + out->z * n.z, lobe = powf(fmaxf(0.0f, vec3_dot(*out, m)), e);
    while (MISTAKE == 11 && mu <= 0.0f) {
        *out = steps.turn_to(steps.sample_lobe(e, rng), m);
        mu = vec3_dot(*out, n);
    }
    if (mu <= 0.0f && MISTAKE != 3)
        return false;
    mu = MISTAKE == 12 ? -vec3_dot(d, n) : MISTAKE == 13 ? mu / 3.0f : fabsf(mu);
    switch (MISTAKE) {
    case 1:
        *weight = (e + 2.0f) / (e + 1.0f);
        break;
    case 2:
        *weight = (e + 2.0f) / (2.0f * PI) * lobe * mu;
        break;
    case 4:
        *weight = (e + 2.0f) / (2.0f * PI) * mu;
        break;
    case 5:
        *weight = (e + 1.0f) / (e + 2.0f) * mu;
        break;
    case 6:
        *weight = lobe;
        break;
    case 7:
        *weight = sqrtf((e + 2.0f) / (e + 1.0f)) * mu;
        break;
    default:
        *weight = (e + 2.0f) / (e + 1.0f) * mu;
    }
    return true;
}
