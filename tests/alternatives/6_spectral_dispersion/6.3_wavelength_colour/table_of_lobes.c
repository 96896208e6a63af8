#include "photonlab.h"

static const struct {
    int of; // 0 x, 1 y, 2 z
    float height, middle, below, above;
} lobes[] = {{0, 1.056f, 599.8f, 37.9f, 31.0f}, {0, 0.362f, 442.0f, 16.0f, 26.7f}, {0, -0.065f, 501.1f, 20.4f, 26.2f},
             {1, 0.821f, 568.8f, 46.9f, 40.5f}, {1, 0.286f, 530.9f, 16.3f, 31.1f}, {2, 1.217f, 437.0f, 11.8f, 36.0f},
             {2, 0.681f, 459.0f, 26.0f, 13.8f}};
static const float matrix[3][3] = {
    {3.2406f, -1.5372f, -0.4986f}, {-0.9689f, 1.8758f, 0.0415f}, {0.0557f, -0.2040f, 1.0570f}};
static const float white[3] = {EQUAL_ENERGY_RED, EQUAL_ENERGY_GREEN, EQUAL_ENERGY_BLUE};

Colour wavelength_colour(float wavelength)
{
    float xyz[3] = {0.0f, 0.0f, 0.0f}, rgb[3] = {0.0f, 0.0f, 0.0f};
    for (size_t i = 0; i < sizeof lobes / sizeof *lobes; i++) {
        float width = wavelength < lobes[i].middle ? lobes[i].below : lobes[i].above;
        float t = (wavelength - lobes[i].middle) / width;
        xyz[lobes[i].of] += lobes[i].height * expf(-t * t / 2.0f);
    }
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++)
            rgb[r] += matrix[r][c] * xyz[c] / white[r];
    return colour(rgb[0], rgb[1], rgb[2]);
}
