// Step 6.1: the refractive index at a wavelength. Contract: lib/steps/6_spectral_dispersion.h
#include "photonlab.h"

float index_at_wavelength(const Material *glass, float wavelength)
{
    // BEGIN SOLUTION
    // 1. The formulas take the square of the wavelength in micrometres.
    double micrometres = 1e-3 * (double)wavelength;
    double squared = micrometres * micrometres;

    // 2. Glass without measured coefficients has Cauchy's two.
    if (!glass->sellmeier)
        return glass->cauchy[0] + glass->cauchy[1] / (float)squared;

    // 3. Sum the terms of Sellmeier's formula, which gives n².
    double n2 = 1.0;
    for (int i = 0; i < SELLMEIER_TERMS; i++)
        n2 += glass->sellmeier->b[i] * squared / (squared - glass->sellmeier->c[i]);
    return (float)sqrt(n2);
    // STUB: return 1.5f;
    // END SOLUTION
}
