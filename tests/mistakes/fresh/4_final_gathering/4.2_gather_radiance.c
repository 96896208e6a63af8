//1 pi_missing               ρE
//2 squeeze_missing          no η²
//3 mirror_ends              mirrors are black
//4 glass_straight           through glass without bending
//5 weight_forgotten         what mirrors took
//6 -                        ends at the second mirror or glass
#include "photonlab.h"
Colour gather_radiance(GatherTrace *T, Ray ray, Rng *rng)
{
    float r = 1.0f, g = 1.0f, b = 1.0f;
    int met = 0;
    for (Hit h; gather_meet(T, &ray, &h); met++) {
        const Material *m = h.material;
        if (m->type == MATERIAL_LIGHT || (MISTAKE == 6 && met == 2) || (MISTAKE == 3 && m->type == MATERIAL_MIRROR))
            break;
        if (material_is_rough(m)) {
            Colour a = gather_albedo(T, &ray, &h), E = gather_irradiance(T, &h);
            float f = MISTAKE == 1 ? 1.0f : 1.0f / PI;
            if (MISTAKE == 5)
                r = g = b = 1.0f;
            return colour(r * a.r * E.r * f, g * a.g * E.g * f, b * a.b * E.b * f);
        }
        Vec3 d = steps.reflect(ray.direction, h.normal);
        if (m->type == MATERIAL_MIRROR) {
            r *= m->specular.r, g *= m->specular.g, b *= m->specular.b;
        } else {
            float eta = glass_eta(&h, steps.refractive_index(m, WHITE)),
                  F = steps.fresnel(-vec3_dot(ray.direction, h.normal), eta);
            Vec3 through;
            if (rng_float(rng) >= F && steps.refract(ray.direction, h.normal, eta, &through)) {
                d = MISTAKE == 4 ? ray.direction : through;
                float s = MISTAKE == 2 ? 1.0f : eta * eta;
                r *= s, g *= s, b *= s;
            }
        }
        ray = (Ray){h.position, d, h.primitive};
    }
    return colour(0.0f, 0.0f, 0.0f);
}
