// A plain path tracer, to check the photons against: a different method, sharing only the scene and the BRDF.
#include "render/eye.h"
#include "scene/material_kind.h"

#define ROULETTE_FROM 8 // bounces that are followed without roulette

// Reflects or refracts at random. The first time white light meets dispersing glass one channel is chosen and the
// others are dropped; it then counts three times.
static Colour sample_glass(Eye *eye, const Hit *hit, Vec3 *direction, int *channel)
{
    const Material *glass = hit->material;
    Colour factor = colour_grey(1.0f);
    if (glass->disperses && *channel < 0) {
        *channel = (int)(rng_float(&eye->rng) * 3.0f);
        factor = colour_only(*channel, 3.0f);
    }
    float index = glass->index[*channel < 0 ? 0 : *channel];
    Vec3 refracted;
    float reflected_share = glass_optics(hit, *direction, index, &refracted);
    if (rng_float(&eye->rng) < reflected_share) {
        *direction = mirror_direction(*direction, hit->normal);
        return factor;
    }
    *direction = refracted;
    float into = hit->entering ? 1.0f / index : index;
    return colour_scale(factor, into * into);
}

// Draws the way on from a rough surface; its factor: BRDF, cosine and density. False when the draw fell below it.
static bool sample_brdf(Eye *eye, const Hit *hit, Vec3 wo, Vec3 *wi, Colour *factor)
{
    float choice = rng_float(&eye->rng);
    float u = rng_float(&eye->rng);
    float v = rng_float(&eye->rng);
    float pdf;
    float lobe_share = material_kind(hit->material)->cosine_lobe ? 0.5f : 0.0f;
    if (!sample_rough(hit, wo, lobe_share, choice, u, v, wi, &pdf))
        return false;
    Colour f = material_brdf(hit->material, eye->options->play.glossy, *wi, wo, hit->normal);
    *factor = colour_scale(f, vec3_dot(*wi, hit->normal) / pdf);
    return true;
}

Colour path_radiance(Eye *eye, Ray ray)
{
    Colour sum = colour_grey(0.0f);
    Colour throughput = colour_grey(1.0f);
    bool see_lights = true; // not after a rough bounce: direct_light has counted them there
    int channel = -1;
    for (int bounce = 0; bounce <= eye->options->settings.depth; bounce++) {
        Hit hit;
        eye->rays++;
        if (!scene_intersect(eye->scene, &ray, &hit))
            return sum;
        const MaterialKind *kind = material_kind(hit.material);
        Vec3 wo = vec3_negate(ray.direction);
        Colour factor = colour_grey(1.0f);
        switch (kind->optics) {
        case OPTICS_LIGHT:
            if (see_lights && hit.entering)
                sum = colour_add(sum, colour_mul(throughput, hit.material->radiance));
            return sum;
        case OPTICS_MIRROR:
            ray.direction = kind->turn(ray.direction, hit.normal);
            factor = hit.material->specular;
            break;
        case OPTICS_GLASS:
            factor = sample_glass(eye, &hit, &ray.direction, &channel);
            break;
        case OPTICS_ROUGH:
            sum = colour_add(sum, colour_mul(throughput, direct_light(eye, &hit, wo)));
            if (!sample_brdf(eye, &hit, wo, &ray.direction, &factor))
                return sum;
            break;
        }
        see_lights = kind->optics != OPTICS_ROUGH;
        throughput = colour_mul(throughput, factor);
        if (bounce >= ROULETTE_FROM) {
            float survival = fminf(0.95f, colour_max(throughput));
            if (rng_float(&eye->rng) >= survival)
                return sum;
            throughput = colour_scale(throughput, 1.0f / survival);
        }
        ray.origin = hit.position;
        ray.from = hit.primitive;
    }
    return sum;
}
