// Step 6.1: the refractive index at a wavelength. Contract: lib/steps/6_spectral_dispersion.h
#include "photonlab.h"

float index_at_wavelength(const Material *glass, float wavelength)
{
    todo("6.1"), (void)glass, (void)wavelength; // take this line away when you start

    // 1. The formulas take the square of the wavelength in micrometres.

    // 2. Glass without measured coefficients has Cauchy's two.

    // 3. Sum the terms of Sellmeier's formula, which gives n².

    return 1.5f;
}
