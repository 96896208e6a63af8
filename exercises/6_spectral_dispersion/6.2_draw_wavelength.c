// Step 6.2: draw a wavelength by importance. Contract: lib/steps/6_spectral_dispersion.h
#include "photonlab.h"

float draw_wavelength(float u, float *weight)
{
    todo("6.2"); // take this line away when you start

    // 1. The tangent at both ends of the range, and u of the way from one to the other.

    // 2. Turn the tangent back into a wavelength.

    // 3. Divide by the density, which is the tangent's slope: 1/cosh² = 1 − tanh².

    *weight = 1.0f;
    return WAVELENGTH_MIDDLE + 0.0f * u;
}
