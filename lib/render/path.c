// A plain path tracer, to check the photons against: a different method, sharing only the scene and the BRDF.
#include "render/eye.h"

#define ROULETTE_FROM 8 // bounces that are followed without roulette

// Reflects or refracts at random. The first time white light meets dispersing glass one channel is chosen and the
// others are dropped; it then counts three times.
static Colour sample_glass(Eye *eye, const Hit *hit, Vec3 *direction, int *channel)
{
    const Material *glass = hit->material;
    Colour factor = colour_grey(1.0f);
    if (glass->disperses && *channel < 0) {
        *channel = (int)(rng_float(&eye->rng) * 3.0f);
        factor = colour_grey(0.0f);
        colour_set_channel(&factor, *channel, 3.0f);
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
            break;
        Vec3 wo = vec3_negate(ray.direction);
        Colour factor = colour_grey(1.0f);
        if (hit.material->type == MATERIAL_LIGHT) {
            if (see_lights && hit.entering)
                sum = colour_add(sum, colour_mul(throughput, hit.material->radiance));
            break;
        } else if (hit.material->type == MATERIAL_MIRROR) {
            ray.direction = mirror_direction(ray.direction, hit.normal);
            factor = hit.material->specular;
            see_lights = true;
        } else if (hit.material->type == MATERIAL_GLASS) {
            factor = sample_glass(eye, &hit, &ray.direction, &channel);
            see_lights = true;
        } else {
            sum = colour_add(sum, colour_mul(throughput, direct_light(eye, &hit, wo)));
            float choice = rng_float(&eye->rng);
            float u = rng_float(&eye->rng);
            float v = rng_float(&eye->rng);
            float pdf;
            float lobe_share = hit.material->type == MATERIAL_GLOSSY ? 0.5f : 0.0f;
            if (!sample_rough(&hit, wo, lobe_share, choice, u, v, &ray.direction, &pdf))
                break;
            Colour f = material_brdf(hit.material, eye->options->play.glossy, ray.direction, wo, hit.normal);
            factor = colour_scale(f, vec3_dot(ray.direction, hit.normal) / pdf);
            see_lights = false;
        }
        throughput = colour_mul(throughput, factor);
        if (bounce >= ROULETTE_FROM) {
            float survival = fminf(0.95f, colour_max(throughput));
            if (rng_float(&eye->rng) >= survival)
                break;
            throughput = colour_scale(throughput, 1.0f / survival);
        }
        ray.origin = hit.position;
        ray.from = hit.primitive;
    }
    return sum;
}
