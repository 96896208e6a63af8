// Refraction is tried first; squeezing is kept apart from the colour.
#include "photonlab.h"

Colour gather_radiance(GatherTrace *trace, Ray ray, Rng *rng)
{
    Colour tint = colour(1, 1, 1);
    float squeeze = 1.0f;
    Hit hit;
    bool on = gather_meet(trace, &ray, &hit);
    while (on && !material_is_rough(hit.material)) {
        if (hit.material->type == MATERIAL_LIGHT)
            return colour(0, 0, 0);
        ray.origin = hit.position;
        ray.from = hit.primitive;
        Vec3 refracted = hit.normal;
        bool passes = false;
        if (hit.material->type == MATERIAL_GLASS) {
            float eta = glass_eta(&hit, steps.refractive_index(hit.material, WHITE));
            passes = steps.refract(ray.direction, hit.normal, eta, &refracted);
            float reflected = passes ? steps.fresnel(fabsf(vec3_dot(ray.direction, hit.normal)), eta) : 1.0f;
            passes = passes && rng_float(rng) >= reflected;
            squeeze *= passes ? eta * eta : 1.0f;
        } else {
            tint = colour_mul(tint, hit.material->specular);
        }
        ray.direction = passes ? refracted : steps.reflect(ray.direction, hit.normal);
        on = gather_meet(trace, &ray, &hit);
    }
    if (!on)
        return colour(0, 0, 0);
    Colour leaving = colour_mul(gather_irradiance(trace, &hit), gather_albedo(trace, &ray, &hit));
    return colour_scale(colour_mul(leaving, tint), squeeze / PI);
}
