// Adds in pairs of halves: less rounding than one after the other.
#include "photonlab.h"

typedef struct {
    const Hit *hit;
    const Gather *gather;
    Vec3 wo;
    float per_radius;
} Place;

static Colour one_photon(const Place *place, const NearPhoton *near)
{
    if (!stored_photon_on_side(near->photon, place->hit->normal))
        return colour_grey(0.0f);
    Colour f = gather_brdf(place->gather, place->hit, near->photon, place->wo);
    float cone = 1.0f - place->per_radius * sqrtf(near->distance2);
    return colour_mul(colour_scale(near->photon->power, cone), f);
}

static Colour add_up(const Place *place, size_t from, size_t to)
{
    if (to - from == 1)
        return one_photon(place, &place->gather->near[from]);
    size_t half = from + (to - from) / 2;
    return colour_add(add_up(place, from, half), add_up(place, half, to));
}

Colour estimate_radiance(const PhotonMap *map, const Hit *hit, Vec3 wo, Gather *gather)
{
    float r;
    size_t found = gather_near(map, hit->position, gather, &r);
    if (found == 0 || !(r > 0.0f))
        return colour_grey(0.0f);
    Place place = {hit, gather, wo, 1.0f / r};
    return colour_scale(add_up(&place, 0, found), 3.0f * place.per_radius * place.per_radius / PI);
}
