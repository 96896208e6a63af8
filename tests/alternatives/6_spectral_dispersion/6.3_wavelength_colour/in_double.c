#include "photonlab.h"

static double g(double l, double mu, double s1, double s2)
{
    double s = l < mu ? s1 : s2;
    return exp(-(l - mu) * (l - mu) / (2.0 * s * s));
}

Colour wavelength_colour(float wavelength)
{
    double l = wavelength;
    double x = 1.056 * g(l, 599.8, 37.9, 31.0) + 0.362 * g(l, 442.0, 16.0, 26.7) - 0.065 * g(l, 501.1, 20.4, 26.2);
    double y = 0.821 * g(l, 568.8, 46.9, 40.5) + 0.286 * g(l, 530.9, 16.3, 31.1);
    double z = 1.217 * g(l, 437.0, 11.8, 36.0) + 0.681 * g(l, 459.0, 26.0, 13.8);
    double r = 3.2406 * x - 1.5372 * y - 0.4986 * z;
    double gr = -0.9689 * x + 1.8758 * y + 0.0415 * z;
    double b = 0.0557 * x - 0.2040 * y + 1.0570 * z;
    return colour((float)(r / EQUAL_ENERGY_RED), (float)(gr / EQUAL_ENERGY_GREEN), (float)(b / EQUAL_ENERGY_BLUE));
}
