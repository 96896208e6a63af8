// The turn by the chord between the normals: 1 − n·n_i = |n − n_i|²/2.
#include "photonlab.h"

bool interpolate_irradiance(const IrradianceEstimate *const near[], size_t count, Vec3 position, Vec3 normal,
                            float accuracy, Colour *irradiance)
{
    float weights = 0.0f;
    Colour sum = colour_grey(0.0f);
    for (size_t i = 0; i < count; ++i) {
        const IrradianceEstimate e = *near[i];
        Vec3 d = vec3_sub(position, e.position);
        float chord = vec3_length(vec3_sub(normal, e.normal));
        float error = vec3_length(d) / e.reach + chord / sqrtf(2.0f);
        bool below = vec3_dot(d, vec3_add(normal, e.normal)) < -0.1f * accuracy * e.reach;
        if (error < accuracy && !below) {
            float w = (accuracy - error) / accuracy;
            weights += w;
            sum = colour_add(sum, colour_scale(irradiance_extrapolate(near[i], position, normal), w));
        }
    }
    if (weights == 0.0f)
        return false;
    *irradiance = colour_scale(sum, 1.0f / weights);
    return true;
}
