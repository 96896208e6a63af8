// Step 4.5: irradiance by the estimates near a place. Contract: lib/steps/4_final_gathering.h
#include "photonlab.h"

bool interpolate_irradiance(const IrradianceEstimate *const near[], size_t count, Vec3 position, Vec3 normal,
                            float accuracy, Colour *irradiance)
{
    // BEGIN SOLUTION
    Colour sum = colour_grey(0.0f);
    float weights = 0.0f;
    for (size_t i = 0; i < count; i++) {
        const IrradianceEstimate *estimate = near[i];
        Vec3 offset = vec3_sub(position, estimate->position);

        // 1. How wrong may this one be here? Far away or turned away, it does not serve.
        float turned = fmaxf(0.0f, 1.0f - vec3_dot(normal, estimate->normal));
        float error = vec3_length(offset) / estimate->reach + sqrtf(turned);
        if (error >= accuracy)
            continue;

        // 2. Nor does it where the place lies below its surface: it has seen what the place does not see.
        float height = 0.5f * vec3_dot(offset, vec3_add(normal, estimate->normal));
        if (height < -0.05f * accuracy * estimate->reach)
            continue;

        // 3. Weigh what it says of this place.
        float weight = 1.0f - error / accuracy;
        sum = colour_add(sum, colour_scale(irradiance_extrapolate(estimate, position, normal), weight));
        weights += weight;
    }

    // 4. The mean, if any serves.
    if (weights <= 0.0f)
        return false;
    *irradiance = colour_scale(sum, 1.0f / weights);
    return true;
    // STUB: return false;
    // END SOLUTION
}
