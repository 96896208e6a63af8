//1 half_missing             exp(−t²)
//2 clipped                  no negative channels
//3 xyz_for_rgb              no matrix
//4 equal_energy_missing     not divided
//5 third_lobe_missing       the small lobe forgotten
//6 -                        all widths a tenth too large
//11 widths_swapped           above for below
//12 one_white_for_all        green's for all
#include "photonlab.h"
#define G(c, a, b) gauss((double)w - c, a, b)
static double gauss(double d, double a, double b)
{
    double s = (MISTAKE == 11 ? d > 0.0 : d < 0.0) ? a : b;
    if (MISTAKE == 6)
        s *= 1.1;
    return exp(-d * d / ((MISTAKE == 1 ? 1.0 : 2.0) * s * s));
}
Colour wavelength_colour(float w)
{
    double x = 1.056 * G(599.8, 37.9, 31.0) + 0.362 * G(442.0, 16.0, 26.7) -
               (MISTAKE == 5 ? 0.0 : 0.065) * G(501.1, 20.4, 26.2);
    double y = 0.821 * G(568.8, 46.9, 40.5) + 0.286 * G(530.9, 16.3, 31.1),
           z = 1.217 * G(437.0, 11.8, 36.0) + 0.681 * G(459.0, 26.0, 13.8);
    double c[3] = {3.2406 * x - 1.5372 * y - 0.4986 * z, -0.9689 * x + 1.8758 * y + 0.0415 * z,
                   0.0557 * x - 0.2040 * y + 1.0570 * z};
    const double e[3] = {(double)EQUAL_ENERGY_RED, (double)EQUAL_ENERGY_GREEN, (double)EQUAL_ENERGY_BLUE};
    if (MISTAKE == 3)
        c[0] = x, c[1] = y, c[2] = z;
    for (int i = 0; i < 3; i++) {
        c[i] /= MISTAKE == 4 ? 1.0 : MISTAKE == 12 ? e[1] : e[i];
        if (MISTAKE == 2 && c[i] < 0.0)
            c[i] = 0.0;
    }
    return colour((float)c[0], (float)c[1], (float)c[2]);
}
