// Step 6.3: the colour of a wavelength. Contract: lib/steps/6_spectral_dispersion.h
#include "photonlab.h"

// A bell about `middle`, of another width on either side.
static float lobe(float wavelength, float middle, float below, float above)
{
    // BEGIN SOLUTION
    // 1. How many widths away from its middle?
    float offset = (wavelength - middle) / (wavelength < middle ? below : above);
    return expf(-0.5f * offset * offset);
    // STUB: return wavelength == middle ? 1.0f : 0.0f * below * above;
    // END SOLUTION
}

Colour wavelength_colour(float wavelength)
{
    // BEGIN SOLUTION
    // 2. What the three kinds of receptors of a standard observer make of it: CIE 1931.
    float x = 1.056f * lobe(wavelength, 599.8f, 37.9f, 31.0f) + 0.362f * lobe(wavelength, 442.0f, 16.0f, 26.7f) -
              0.065f * lobe(wavelength, 501.1f, 20.4f, 26.2f);
    float y = 0.821f * lobe(wavelength, 568.8f, 46.9f, 40.5f) + 0.286f * lobe(wavelength, 530.9f, 16.3f, 31.1f);
    float z = 1.217f * lobe(wavelength, 437.0f, 11.8f, 36.0f) + 0.681f * lobe(wavelength, 459.0f, 26.0f, 13.8f);

    // 3. As the screen's red, green and blue, measured by those of equal energy.
    return colour((3.2406f * x - 1.5372f * y - 0.4986f * z) / EQUAL_ENERGY_RED,
                  (-0.9689f * x + 1.8758f * y + 0.0415f * z) / EQUAL_ENERGY_GREEN,
                  (0.0557f * x - 0.2040f * y + 1.0570f * z) / EQUAL_ENERGY_BLUE);
    // STUB: return colour_grey(1.0f);
    // END SOLUTION
}
