// What a smooth surface does to a ray is a function of its own, with double weights.
#include "photonlab.h"

// The weight; 0: the ray ends.
static double turn(Ray *ray, const Hit *hit, Rng *rng)
{
    if (hit->material->type == MATERIAL_LIGHT)
        return 0.0;
    Vec3 d = ray->direction;
    ray->origin = hit->position;
    ray->from = hit->primitive;
    ray->direction = steps.reflect(d, hit->normal);
    if (hit->material->type != MATERIAL_GLASS)
        return 1.0;
    float eta = glass_eta(hit, steps.refractive_index(hit->material, WHITE));
    float transmitted = 1.0f - steps.fresnel(-vec3_dot(d, hit->normal), eta);
    bool through = rng_float(rng) < transmitted && steps.refract(d, hit->normal, eta, &ray->direction);
    return through ? (double)eta * (double)eta : 1.0;
}

Colour gather_radiance(GatherTrace *trace, Ray ray, Rng *rng)
{
    Colour weight = colour_grey(1.0f / PI);
    for (Hit hit; gather_meet(trace, &ray, &hit);) {
        if (material_is_rough(hit.material)) {
            weight = colour_mul(weight, gather_albedo(trace, &ray, &hit));
            return colour_mul(weight, gather_irradiance(trace, &hit));
        }
        if (hit.material->type == MATERIAL_MIRROR)
            weight = colour_mul(weight, hit.material->specular);
        weight = colour_scale(weight, (float)turn(&ray, &hit, rng));
    }
    return colour_grey(0.0f);
}
