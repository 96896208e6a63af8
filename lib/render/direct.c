#include "math/sample.h"
#include "render/eye.h"

Colour direct_light(Eye *eye, const Hit *hit, Vec3 wo)
{
    Colour sum = colour_grey(0.0f);
    for (size_t i = 0; i < eye->scene->light_count; i++) {
        const Light *light = &eye->scene->lights[i];
        float u, v;
        sampler_point(&eye->sampler, SAMPLER_LIGHT + (uint32_t)i, &u, &v);
        LightSample sample;
        if (!light_sample(light, hit->position, u, v, &sample))
            continue;
        float cos_i = vec3_dot(sample.wi, hit->normal);
        if (cos_i <= 0.0f)
            continue;
        Ray shadow = {hit->position, sample.wi, hit->primitive};
        eye->rays++;
        if (scene_occluded(eye->scene, &shadow, sample.distance, light))
            continue;
        Colour f = material_brdf(hit->material, eye->options->play.glossy, sample.wi, wo, hit->normal);
        Colour reflected = eye->options->play.loop == LOOP_WAVELENGTH ? light_reflected(light, f, sample.geometry)
                                                                      : colour_mul(f, sample.arriving);
        sum = colour_add(sum, colour_scale(reflected, cos_i));
    }
    return sum;
}

float glass_optics(const Hit *hit, Vec3 direction, float index, Vec3 *refracted)
{
    float eta = hit->entering ? 1.0f / index : index;
    float cos_i = -vec3_dot(direction, hit->normal);
    float cos2_t = 1.0f - eta * eta * (1.0f - cos_i * cos_i);
    if (cos2_t <= 0.0f)
        return 1.0f;
    float cos_t = sqrtf(cos2_t);
    *refracted = vec3_normalize(vec3_along(vec3_scale(direction, eta), hit->normal, eta * cos_i - cos_t));
    float s = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    float p = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    return 0.5f * (s * s + p * p);
}

bool sample_rough(const Hit *hit, Vec3 wo, float lobe_share, float choice, float u, float v, Vec3 *wi, float *pdf)
{
    float exponent = hit->material->exponent;
    Vec3 mirror = mirror_direction(vec3_negate(wo), hit->normal);
    if (choice < lobe_share) {
        Frame frame = frame_about(mirror);
        *wi = frame_to_world(&frame, direction_at(powf(1.0f - u, 1.0f / (exponent + 1.0f)), v));
    } else {
        *wi = sample_cosine(hit->normal, u, v);
    }
    float cos_i = vec3_dot(*wi, hit->normal);
    if (cos_i <= 0.0f)
        return false;
    *pdf = (1.0f - lobe_share) * cos_i / PI;
    float cos_alpha = vec3_dot(*wi, mirror);
    if (lobe_share > 0.0f && cos_alpha > 0.0f)
        *pdf += lobe_share * (exponent + 1.0f) / (2.0f * PI) * powf(cos_alpha, exponent);
    return *pdf > 0.0f;
}
