#include "photonlab.h"

static float lobe(float wavelength, float middle, float below, float above)
{
    float width = wavelength >= middle ? above : below;
    return expf(-powf((wavelength - middle) / width, 2.0f) / 2.0f);
}

// x, y and z each bring a colour.
Colour wavelength_colour(float w)
{
    float x = 1.056f * lobe(w, 599.8f, 37.9f, 31.0f) + 0.362f * lobe(w, 442, 16, 26.7f) -
              0.065f * lobe(w, 501.1f, 20.4f, 26.2f);
    float y = 0.821f * lobe(w, 568.8f, 46.9f, 40.5f) + 0.286f * lobe(w, 530.9f, 16.3f, 31.1f);
    float z = 1.217f * lobe(w, 437, 11.8f, 36) + 0.681f * lobe(w, 459, 26, 13.8f);
    Colour sum = colour_scale(colour(3.2406f, -0.9689f, 0.0557f), x);
    sum = colour_add(sum, colour_scale(colour(-1.5372f, 1.8758f, -0.2040f), y));
    sum = colour_add(sum, colour_scale(colour(-0.4986f, 0.0415f, 1.0570f), z));
    return colour_mul(sum, colour(1.0f / EQUAL_ENERGY_RED, 1.0f / EQUAL_ENERGY_GREEN, 1.0f / EQUAL_ENERGY_BLUE));
}
