// What an estimate is worth at the place is a function of its own; 0: it does not serve.
#include "photonlab.h"

static float weight_of(const IrradianceEstimate *estimate, Vec3 position, Vec3 normal, float accuracy)
{
    Vec3 offset = vec3_sub(position, estimate->position);
    Vec3 middle = vec3_scale(vec3_add(normal, estimate->normal), 0.5f);
    if (vec3_dot(offset, middle) < -0.05f * accuracy * estimate->reach)
        return 0.0f;
    float cosine = fminf(1.0f, vec3_dot(estimate->normal, normal));
    float error = vec3_length(offset) / estimate->reach + sqrtf(1.0f - cosine);
    return error < accuracy ? 1.0f - error / accuracy : 0.0f;
}

bool interpolate_irradiance(const IrradianceEstimate *const near[], size_t count, Vec3 position, Vec3 normal,
                            float accuracy, Colour *irradiance)
{
    Colour sum = {0, 0, 0};
    float total = 0.0f;
    for (size_t i = 0; i < count; i++) {
        float weight = weight_of(near[i], position, normal, accuracy);
        if (weight > 0.0f) {
            total += weight;
            sum = colour_add(sum, colour_scale(irradiance_extrapolate(near[i], position, normal), weight));
        }
    }
    if (total > 0.0f)
        *irradiance = colour_scale(sum, 1.0f / total);
    return total > 0.0f;
}
