// Eye rays at glass.
#include "render/eye.h"

#define SPLIT_WEIGHT 0.25f // both ways are followed while the ray still carries this much

// What glass does with one index: the refracted direction and the shares of radiance that come from either way.
static void glass_way(const Eye *eye, const Hit *hit, Vec3 direction, float index, Vec3 *refracted, float *reflected,
                      float *through)
{
    bool front_only = eye->options->glass_sides == 1;
    *refracted = direction;
    *reflected = 0.0f;
    *through = 1.0f;
    if (front_only && !hit->entering) // as if the glass had no back
        return;
    *reflected = glass_optics(hit, direction, index, refracted);
    // Radiance is squeezed into the denser side's narrower cone: L/n² stays the same along a ray (Veach 1996).
    float eta = hit->entering ? 1.0f / index : index;
    *through = (1.0f - *reflected) * (front_only ? 1.0f : eta * eta);
}

// One of both ways by chance, where the ray is faint: what either then counts.
static void take_ways(Eye *eye, Colour weight, float reflected, float *take_reflected, float *take_through)
{
    *take_reflected = *take_through = 1.0f;
    if (colour_max(weight) >= SPLIT_WEIGHT)
        return;
    bool reflect = rng_float(&eye->rng) < reflected;
    *take_reflected = reflect ? 1.0f / reflected : 0.0f;
    *take_through = reflect ? 0.0f : 1.0f / (1.0f - reflected);
}

// Light through dispersing glass, with wavelengths: a ray of all of them refracts three ways, each by a wavelength of its own, spread
// evenly over the pixel's samples. What comes back is red, green and blue; at that wavelength it is taken as a wall's reflectance
// would be, and it has the wavelength's colour. In the mean that is the light that came.
static Colour spectral_glass(Eye *eye, const Hit *hit, Vec3 direction, EyeRay carried)
{
    float wavelength[3] = {carried.wavelength}, weight[3] = {1.0f}, through[3], place, unused;
    Vec3 refracted[3];
    int ways = carried.wavelength > 0.0f ? 1 : 3;
    float reflected = 0.0f, weights = 0.0f;
    sampler_point(&eye->sampler, SAMPLER_WAVE, &place, &unused);
    for (int i = 0; i < ways; i++) {
        float r, u = place + (float)i / 3.0f;
        if (ways > 1)
            wavelength[i] = steps.draw_wavelength(u < 1.0f ? u : u - 1.0f, &weight[i]);
        float index = steps.index_at_wavelength(hit->material, wavelength[i]);
        glass_way(eye, hit, direction, index, &refracted[i], &r, &through[i]);
        reflected += weight[i] * r;
        weights += weight[i];
    }
    reflected = fminf(reflected / weights, 1.0f);

    float take_reflected, take_through;
    take_ways(eye, carried.weight, reflected, &take_reflected, &take_through);
    Vec3 back = mirror_direction(direction, hit->normal);
    Colour sum = eye_follow(eye, hit, back, colour_grey(reflected * take_reflected), carried);
    for (int i = 0; i < ways; i++) {
        EyeRay onward = carried;
        onward.wavelength = wavelength[i];
        float share = through[i] * take_through * weight[i] / (float)ways;
        Colour seen = eye_follow(eye, hit, refracted[i], colour_grey(share), onward);
        if (ways > 1)
            seen = colour_scale(spectral_colour(wavelength[i]), reflectance_at(seen, wavelength[i]));
        sum = colour_add(sum, seen);
    }
    return sum;
}

Colour eye_glass(Eye *eye, const Hit *hit, Vec3 direction, EyeRay carried)
{
    if (eye->options->play.loop == LOOP_WAVELENGTH && hit->material->disperses)
        return spectral_glass(eye, hit, direction, carried);
    bool splits = hit->material->disperses && carried.colour == WHITE;
    int first = carried.colour == WHITE ? 0 : (int)carried.colour - RED;
    int ways = splits ? 3 : 1;
    Colour reflected = colour_grey(0.0f);
    Colour through[3];
    Vec3 refracted[3];
    for (int i = 0; i < ways; i++) {
        float r, t;
        glass_way(eye, hit, direction, hit->material->index[first + i], &refracted[i], &r, &t);
        reflected = splits ? colour_add(reflected, colour_only(i, r)) : colour_grey(r);
        through[i] = splits ? colour_only(i, t) : colour_grey(t);
    }

    float take_reflected, take_through;
    take_ways(eye, carried.weight, colour_sum(reflected) / 3.0f, &take_reflected, &take_through);
    Vec3 back = mirror_direction(direction, hit->normal);
    Colour sum = eye_follow(eye, hit, back, colour_scale(reflected, take_reflected), carried);
    for (int i = 0; i < ways; i++) {
        EyeRay onward = carried;
        onward.colour = splits ? (PhotonColour)(RED + i) : carried.colour;
        sum = colour_add(sum, eye_follow(eye, hit, refracted[i], colour_scale(through[i], take_through), onward));
    }
    return sum;
}
