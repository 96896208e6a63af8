// One sum of the flux, one of flux times distance; the cone joins them at the end.
#include "photonlab.h"

Colour estimate_radiance(const PhotonMap *map, const Hit *hit, Vec3 wo, Gather *gather)
{
    float r = 0.0f;
    size_t n = gather_near(map, hit->position, gather, &r);
    Colour flux = colour_grey(0.0f);
    Colour moment = colour_grey(0.0f);
    for (size_t i = n; i-- > 0;) {
        NearPhoton near = gather->near[i];
        if (!stored_photon_on_side(near.photon, hit->normal))
            continue;
        Colour part = colour_mul(gather_brdf(gather, hit, near.photon, wo), near.photon->power);
        flux = colour_add(flux, part);
        moment = colour_add(moment, colour_scale(part, sqrtf(near.distance2)));
    }
    if (!(r > 0.0f))
        return colour_grey(0.0f);
    float volume = PI * r * r / 3.0f;
    return colour_scale(colour_sub(flux, colour_scale(moment, 1.0f / r)), 1.0f / volume);
}
