// Sums in double precision, the side tested by the unpacked direction, the BRDF asked for in full.
#include "photonlab.h"

Colour estimate_radiance(const PhotonMap *map, const Hit *hit, Vec3 wo, Gather *gather)
{
    float radius;
    size_t found = gather_near(map, hit->position, gather, &radius);
    double r = radius, sum[3] = {0.0, 0.0, 0.0};
    for (size_t i = 0; i < found; i++) {
        const StoredPhoton *photon = gather->near[i].photon;
        Vec3 wi = stored_photon_wi(photon);
        if (vec3_dot(wi, hit->normal) <= 0.0f)
            continue;
        double w = r - sqrt((double)gather->near[i].distance2);
        Colour f = material_brdf(hit->material, gather->glossy, wi, wo, hit->normal);
        sum[0] += (double)(f.r * photon->power.r) * w;
        sum[1] += (double)(f.g * photon->power.g) * w;
        sum[2] += (double)(f.b * photon->power.b) * w;
    }
    double scale = r > 0.0 ? 3.0 / ((double)PI * r * r * r) : 0.0;
    return colour((float)(sum[0] * scale), (float)(sum[1] * scale), (float)(sum[2] * scale));
}
