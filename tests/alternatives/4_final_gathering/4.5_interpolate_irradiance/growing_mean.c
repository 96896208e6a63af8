// A weighted mean that grows, backwards through the list.
#include "photonlab.h"

bool interpolate_irradiance(const IrradianceEstimate *const near[], size_t count, Vec3 position, Vec3 normal,
                            float accuracy, Colour *irradiance)
{
    Colour mean = colour_grey(0.0f);
    float weights = 0.0f;
    for (size_t i = count; i-- > 0;) {
        const IrradianceEstimate *const estimate = near[i];
        Vec3 to_place = vec3_sub(position, estimate->position);
        float distance = sqrtf(vec3_dot(to_place, to_place));
        float turned = 1.0f - vec3_dot(normal, estimate->normal);
        turned = turned > 0.0f ? sqrtf(turned) : 0.0f;
        float worth = 1.0f - (distance / estimate->reach + turned) / accuracy;
        float height = 0.5f * (vec3_dot(to_place, normal) + vec3_dot(to_place, estimate->normal));
        bool serves = worth > 0.0f && height >= -0.05f * accuracy * estimate->reach;
        if (!serves)
            continue;
        weights += worth;
        Colour off = colour_sub(irradiance_extrapolate(estimate, position, normal), mean);
        mean = colour_add(mean, colour_scale(off, worth / weights));
    }
    if (weights > 0.0f)
        *irradiance = mean;
    return weights > 0.0f;
}
