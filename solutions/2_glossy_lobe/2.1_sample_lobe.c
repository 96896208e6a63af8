// Step 2.1: a direction in the cosine lobe about +z. Contract: lib/steps/2_glossy_lobe.h
#include "photonlab.h"

Vec3 sample_lobe(float exponent, Rng *rng)
{
    // BEGIN SOLUTION
    // 1. Draw the angle to the axis by inverting the lobe's density. 1 − u is never 0, so its logarithm is finite.
    float u1 = 1.0f - rng_float(rng);
    float u2 = rng_float(rng);
    float log_cos = logf(u1) / (exponent + 1.0f);
    float cos_alpha = expf(log_cos);
    float sin_alpha = sqrtf(-expm1f(2.0f * log_cos));

    // 2. Draw the angle about the axis uniformly.
    float phi = 2.0f * PI * u2;
    return vec3(sin_alpha * cosf(phi), sin_alpha * sinf(phi), cos_alpha);
    // STUB: return vec3(0.0f, 0.0f, 1.0f);
    // END SOLUTION
}
