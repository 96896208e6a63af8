// Channel by channel, with a jump out of the loop.
#include "photonlab.h"

Colour gather_radiance(GatherTrace *trace, Ray ray, Rng *rng)
{
    float weight[3] = {1.0f, 1.0f, 1.0f};
    Colour result = colour_grey(0.0f);
    for (;;) {
        Hit hit;
        if (!gather_meet(trace, &ray, &hit) || hit.material->type == MATERIAL_LIGHT)
            return result;
        if (hit.material->type == MATERIAL_DIFFUSE || hit.material->type == MATERIAL_GLOSSY) {
            Colour albedo = gather_albedo(trace, &ray, &hit), irradiance = gather_irradiance(trace, &hit);
            for (int c = 0; c < 3; c++)
                colour_set_channel(&result, c,
                                   weight[c] * colour_channel(albedo, c) * colour_channel(irradiance, c) / PI);
            return result;
        }
        bool is_mirror = hit.material->type == MATERIAL_MIRROR;
        float eta = is_mirror ? 1.0f : glass_eta(&hit, steps.refractive_index(hit.material, WHITE));
        bool reflects = is_mirror;
        if (!is_mirror) {
            float xi = rng_float(rng);
            reflects = xi < steps.fresnel(-vec3_dot(hit.normal, ray.direction), eta);
        }
        Vec3 next = ray.direction;
        if (reflects || !steps.refract(ray.direction, hit.normal, eta, &next)) {
            next = steps.reflect(ray.direction, hit.normal);
            eta = 1.0f;
        }
        for (int c = 0; c < 3; c++)
            weight[c] *= is_mirror ? colour_channel(hit.material->specular, c) : eta * eta;
        ray.origin = hit.position;
        ray.direction = next;
        ray.from = hit.primitive;
    }
}
