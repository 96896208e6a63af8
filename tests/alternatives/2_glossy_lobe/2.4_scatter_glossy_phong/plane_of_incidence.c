// The lobe's tangents lie in and across the plane of incidence.
#include "photonlab.h"

static Vec3 tangent_of(Vec3 axis, Vec3 normal)
{
    Vec3 across = vec3_cross(normal, axis);
    if (vec3_dot(across, across) < 1e-6f)
        across = fabsf(axis.x) < 0.5f ? vec3_cross(vec3(1, 0, 0), axis) : vec3_cross(vec3(0, 1, 0), axis);
    return vec3_normalize(across);
}

bool scatter_glossy_phong(Vec3 direction, Vec3 normal, float exponent, Rng *rng, Vec3 *out, float *weight)
{
    Vec3 axis = steps.reflect(direction, normal);
    Vec3 across = tangent_of(axis, normal);
    Vec3 within = vec3_cross(axis, across);
    Vec3 lobe = steps.sample_lobe(exponent, rng);
    *out = vec3_add(vec3_scale(axis, lobe.z), vec3_add(vec3_scale(across, lobe.x), vec3_scale(within, lobe.y)));
    float cos_o = fmaxf(0.0f, vec3_dot(normal, *out));
    if (cos_o == 0.0f)
        return false;
    float gain = (2.0f + exponent) / (1.0f + exponent);
    *weight = gain * cos_o;
    return true;
}
