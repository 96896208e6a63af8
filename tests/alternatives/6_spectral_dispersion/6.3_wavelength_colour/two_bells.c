#include "photonlab.h"

// Both halves of a bell as functions of their own.
static float left(float t, float width)
{
    return expf(-0.5f * (t / width) * (t / width));
}

static float bell(float wavelength, float middle, float below, float above)
{
    if (wavelength > middle)
        return left(wavelength - middle, above);
    return left(middle - wavelength, below);
}

Colour wavelength_colour(float wavelength)
{
    float x = 0.362f * bell(wavelength, 442.0f, 16.0f, 26.7f);
    x += 1.056f * bell(wavelength, 599.8f, 37.9f, 31.0f);
    x -= 0.065f * bell(wavelength, 501.1f, 20.4f, 26.2f);
    float y = 0.286f * bell(wavelength, 530.9f, 16.3f, 31.1f);
    y += 0.821f * bell(wavelength, 568.8f, 46.9f, 40.5f);
    float z = 0.681f * bell(wavelength, 459.0f, 26.0f, 13.8f);
    z += 1.217f * bell(wavelength, 437.0f, 11.8f, 36.0f);
    Colour c = colour(0.0f, 0.0f, 0.0f);
    c.r = (3.2406f * x - 1.5372f * y - 0.4986f * z) * (1.0f / EQUAL_ENERGY_RED);
    c.g = (1.8758f * y - 0.9689f * x + 0.0415f * z) * (1.0f / EQUAL_ENERGY_GREEN);
    c.b = (1.0570f * z + 0.0557f * x - 0.2040f * y) * (1.0f / EQUAL_ENERGY_BLUE);
    return c;
}
