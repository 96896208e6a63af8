//1 distance_squared_over_r  the root of distance2 is forgotten
//2 cosine_extra             times the cosine
//3 back_side                both sides
//4 divided_by_k_too         over the number as well
//5 factor                   a sphere's 4πr²
//6 distance_squared         1 − (d/r)²
//7 -                        the largest allowed radius for r
//8 pi_missing               π forgotten in the area
//11 no_cone_but_its_volume  all the same, and the 3 left
//12 brdf_missing            no BRDF
//13 distance_not_scaled     1 − d
//14 pi_twice                π once more
#include "photonlab.h"
Colour estimate_radiance(const PhotonMap *map, const Hit *hit, Vec3 wo, Gather *g)
{
    float R = 0.0f, red = 0.0f, green = 0.0f, blue = 0.0f;
    int n = (int)gather_near(map, hit->position, g, &R);
    if (n < 1 || !(R > 0.0f))
        return colour(0.0f, 0.0f, 0.0f);
    if (MISTAKE == 7 && isfinite(g->radius) && g->radius > 0.0f)
        R = g->radius;
    for (int k = n - 1; k >= 0; k--) {
        const StoredPhoton *p = g->near[k].photon;
        Vec3 wi = stored_photon_wi(p);
        float mu = vec3_dot(wi, hit->normal), d2 = g->near[k].distance2;
        if (mu <= 0.0f && MISTAKE != 3)
            continue;
        float t = MISTAKE == 1 ? d2 / R : MISTAKE == 6 ? d2 / (R * R) : sqrtf(d2) / R, w = 1.0f - t;
        if (MISTAKE == 11)
            w = 1.0f;
        if (MISTAKE == 13)
            w = 1.0f - sqrtf(d2);
        if (MISTAKE == 2)
            w *= mu;
        Colour brdf = gather_brdf(g, hit, p, wo);
        if (MISTAKE == 12)
            brdf = colour(1.0f, 1.0f, 1.0f);
        red += w * brdf.r * p->power.r, green += w * brdf.g * p->power.g, blue += w * brdf.b * p->power.b;
    }
    float area = (MISTAKE == 8 ? 1.0f : MISTAKE == 5 ? 4.0f * PI : PI) * R * R, scale = 3.0f / area;
    if (MISTAKE == 14)
        scale /= PI;
    if (MISTAKE == 4)
        scale /= (float)n;
    return colour(red * scale, green * scale, blue * scale);
}
