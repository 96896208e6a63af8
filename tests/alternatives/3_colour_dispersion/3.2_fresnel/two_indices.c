// With two indices, eta on this side and 1 on the other, in double precision.
#include "photonlab.h"

static double squared(double x)
{
    return x * x;
}

float fresnel(float cos_i, float eta)
{
    double n_i = eta, n_t = 1.0, c_i = cos_i;
    double sin2_t = squared(n_i / n_t) * (1.0 - c_i * c_i);
    if (sin2_t > 1.0)
        return 1.0f;
    double c_t = sqrt(1.0 - sin2_t);
    double parallel = squared((n_t * c_i - n_i * c_t) / (n_t * c_i + n_i * c_t));
    double perpendicular = squared((n_i * c_i - n_t * c_t) / (n_i * c_i + n_t * c_t));
    return (float)((parallel + perpendicular) / 2.0);
}
