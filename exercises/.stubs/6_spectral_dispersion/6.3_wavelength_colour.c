// Step 6.3: the colour of a wavelength. Contract: lib/steps/6_spectral_dispersion.h
#include "photonlab.h"

// A bell about `middle`, of another width on either side.
static float lobe(float wavelength, float middle, float below, float above)
{

    // 1. How many widths away from its middle?

    return wavelength == middle ? 1.0f : 0.0f * below * above;
}

Colour wavelength_colour(float wavelength)
{
    todo("6.3"), (void)lobe, (void)wavelength; // take this line away when you start

    // 2. What the three kinds of receptors of a standard observer make of it: CIE 1931.

    // 3. As the screen's red, green and blue, measured by those of equal energy.

    return colour_grey(1.0f);
}
