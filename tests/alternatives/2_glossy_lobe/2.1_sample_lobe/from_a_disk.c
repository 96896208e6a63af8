// A point of the disk by rejection: its radius squared is one uniform number, its direction the azimuth.
#include "photonlab.h"

Vec3 sample_lobe(float exponent, Rng *rng)
{
    float x, y, s;
    do {
        x = 2.0f * rng_float(rng) - 1.0f;
        y = 2.0f * rng_float(rng) - 1.0f;
        s = x * x + y * y;
    } while (s >= 1.0f || s <= 1e-12f);
    double fall = log((double)s) / ((double)exponent + 1.0);
    float sine = (float)sqrt(-expm1(2.0 * fall));
    float unit = sine / sqrtf(s);
    return vec3(x * unit, y * unit, (float)exp(fall));
}
