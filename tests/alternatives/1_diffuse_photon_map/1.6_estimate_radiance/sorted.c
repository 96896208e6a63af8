// Adds from the farthest photon to the nearest, after sorting them.
#include "photonlab.h"

static void sort_far_first(NearPhoton *near, size_t count)
{
    for (size_t i = 1; i < count; i++) {
        NearPhoton moving = near[i];
        size_t place = i;
        for (; place > 0 && near[place - 1].distance2 < moving.distance2; place--)
            near[place] = near[place - 1];
        near[place] = moving;
    }
}

Colour estimate_radiance(const PhotonMap *map, const Hit *hit, Vec3 wo, Gather *gather)
{
    float reach;
    size_t count = gather_near(map, hit->position, gather, &reach);
    if (count < 1 || reach == 0.0f)
        return colour_grey(0.0f);
    sort_far_first(gather->near, count);
    Colour light = colour_grey(0.0f);
    for (const NearPhoton *one = gather->near; one < gather->near + count; one++) {
        float height = stored_photon_on_side(one->photon, hit->normal) ? 1.0f - sqrtf(one->distance2) / reach : 0.0f;
        Colour f = gather_brdf(gather, hit, one->photon, wo);
        Colour density = colour_scale(one->photon->power, 3.0f * height / (PI * reach * reach));
        light = colour_add(light, colour_mul(density, f));
    }
    return light;
}
