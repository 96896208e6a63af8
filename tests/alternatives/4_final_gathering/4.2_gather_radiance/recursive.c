// As a recursion: what the ray brings from its first surface on.
#include "photonlab.h"

static Colour from_glass(GatherTrace *trace, const Ray *ray, const Hit *hit, Rng *rng);

static Colour bring(GatherTrace *trace, Ray ray, Rng *rng)
{
    Hit hit;
    if (!gather_meet(trace, &ray, &hit))
        return colour_grey(0.0f);
    switch (hit.material->type) {
    case MATERIAL_LIGHT:
        return colour_grey(0.0f);
    case MATERIAL_MIRROR: {
        Ray onward = {hit.position, steps.reflect(ray.direction, hit.normal), hit.primitive};
        return colour_mul(hit.material->specular, bring(trace, onward, rng));
    }
    case MATERIAL_GLASS:
        return from_glass(trace, &ray, &hit, rng);
    default:
        return colour_mul(gather_albedo(trace, &ray, &hit), colour_scale(gather_irradiance(trace, &hit), 1.0f / PI));
    }
}

static Colour from_glass(GatherTrace *trace, const Ray *ray, const Hit *hit, Rng *rng)
{
    float eta = glass_eta(hit, steps.refractive_index(hit->material, WHITE));
    Ray onward = {hit->position, {0, 0, 0}, hit->primitive};
    if (rng_float(rng) < steps.fresnel(-vec3_dot(ray->direction, hit->normal), eta) ||
        !steps.refract(ray->direction, hit->normal, eta, &onward.direction)) {
        onward.direction = steps.reflect(ray->direction, hit->normal);
        return bring(trace, onward, rng);
    }
    return colour_scale(bring(trace, onward, rng), eta * eta);
}

Colour gather_radiance(GatherTrace *trace, Ray ray, Rng *rng)
{
    return bring(trace, ray, rng);
}
