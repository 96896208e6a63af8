// Step 3.2: Fresnel reflectance. Contract: lib/steps/3_colour_dispersion.h
#include "photonlab.h"

float fresnel(float cos_i, float eta)
{
    // BEGIN SOLUTION
    // 1. Find cosθ_t by Snell's law; under total reflection everything is reflected.
    float cos2_t = 1.0f - eta * eta * (1.0f - cos_i * cos_i);
    if (cos2_t <= 0.0f)
        return 1.0f;
    float cos_t = sqrtf(cos2_t);

    // 2. Work out the amplitude for both polarisations, and average their squares.
    float r_s = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    float r_p = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    return 0.5f * (r_s * r_s + r_p * r_p);
    // STUB: return 0.0f;
    // END SOLUTION
}
