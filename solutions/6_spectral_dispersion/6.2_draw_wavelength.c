// Step 6.2: draw a wavelength by importance. Contract: lib/steps/6_spectral_dispersion.h
#include "photonlab.h"

float draw_wavelength(float u, float *weight)
{
    // BEGIN SOLUTION
    // 1. The tangent at both ends of the range, and u of the way from one to the other.
    float first = tanhf((WAVELENGTH_FIRST - WAVELENGTH_MIDDLE) / WAVELENGTH_SPREAD);
    float last = tanhf((WAVELENGTH_LAST - WAVELENGTH_MIDDLE) / WAVELENGTH_SPREAD);
    float tangent = first + u * (last - first);

    // 2. Turn the tangent back into a wavelength.
    float wavelength = WAVELENGTH_MIDDLE + WAVELENGTH_SPREAD * atanhf(tangent);

    // 3. Divide by the density, which is the tangent's slope: 1/cosh² = 1 − tanh².
    float density = (1.0f - tangent * tangent) / (WAVELENGTH_SPREAD * (last - first));
    *weight = 1.0f / (WAVELENGTH_RANGE * density);
    return wavelength;
    // STUB: *weight = 1.0f;
    // STUB: return WAVELENGTH_MIDDLE + 0.0f * u;
    // END SOLUTION
}
