// −ln u has the exponential density, and −ln cosα that of a rate n + 1.
#include "photonlab.h"

static float exponential(float rate, Rng *rng)
{
    return -log1pf(-rng_float(rng)) / rate;
}

Vec3 sample_lobe(float exponent, Rng *rng)
{
    float turn = 2.0f * PI * rng_float(rng);
    float depth = exponential(exponent + 1.0f, rng);
    float missing = -expm1f(-depth); // 1 − cosα
    float cosine = 1.0f - missing;
    float sine = sqrtf(missing * (1.0f + cosine));
    return vec3(sine * sinf(turn), -sine * cosf(turn), cosine);
}
