// In double precision, channel by channel; the weights are not scaled, since their sum divides them again.
#include "photonlab.h"

bool interpolate_irradiance(const IrradianceEstimate *const near[], size_t count, Vec3 position, Vec3 normal,
                            float accuracy, Colour *irradiance)
{
    double sum[4] = {0.0, 0.0, 0.0, 0.0};
    for (const IrradianceEstimate *const *at = near; at != near + count; at++) {
        const IrradianceEstimate *e = *at;
        double x = position.x - e->position.x, y = position.y - e->position.y, z = position.z - e->position.z;
        double cosine =
            (double)normal.x * e->normal.x + (double)normal.y * e->normal.y + (double)normal.z * e->normal.z;
        double error = sqrt(x * x + y * y + z * z) / e->reach + (cosine < 1.0 ? sqrt(1.0 - cosine) : 0.0);
        double height = x * (normal.x + e->normal.x) + y * (normal.y + e->normal.y) + z * (normal.z + e->normal.z);
        if (error >= accuracy || height / 2.0 < -0.05 * accuracy * e->reach)
            continue;
        Colour here = irradiance_extrapolate(e, position, normal);
        double weight = accuracy - error;
        for (int c = 0; c < 3; c++)
            sum[c] += weight * colour_channel(here, c);
        sum[3] += weight;
    }
    if (sum[3] == 0.0)
        return false;
    *irradiance = colour((float)(sum[0] / sum[3]), (float)(sum[1] / sum[3]), (float)(sum[2] / sum[3]));
    return true;
}
