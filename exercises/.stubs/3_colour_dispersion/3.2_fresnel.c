// Step 3.2: Fresnel reflectance. Contract: lib/steps/3_colour_dispersion.h
#include "photonlab.h"

float fresnel(float cos_i, float eta)
{
    todo("3.2"), (void)cos_i, (void)eta; // take this line away when you start

    // 1. Find cosθ_t by Snell's law; under total reflection everything is reflected.

    // 2. Work out the amplitude for both polarisations, and average their squares.

    return 0.0f;
}
