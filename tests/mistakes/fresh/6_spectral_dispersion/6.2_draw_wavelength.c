//1 weight_missing          1
//2 weight_upside_down      the density
//3 range_missing|factor    1/p
//4 backwards               from the end
//5 -                       the root of the weight's half
//11 middle_missing          about 0
//12 spread_missing          no spread in p
#include "photonlab.h"
float draw_wavelength(float u, float *weight)
{
    const double m = (double)WAVELENGTH_MIDDLE, s = (double)WAVELENGTH_SPREAD,
                 A = tanh(((double)WAVELENGTH_FIRST - m) / s), B = tanh(((double)WAVELENGTH_LAST - m) / s);
    double x = MISTAKE == 4 ? 1.0 - (double)u : (double)u, t = A * (1.0 - x) + B * x,
           w = m + s * 0.5 * log((1.0 + t) / (1.0 - t));
    double p = 1.0 / (s * (B - A) * pow(cosh((w - m) / s), 2.0)), v = 1.0 / (p * (double)WAVELENGTH_RANGE);
    if (MISTAKE == 11)
        w -= m;
    if (MISTAKE == 12)
        v /= s;
    *weight = (float)(MISTAKE == 1   ? 1.0
                      : MISTAKE == 2 ? 1.0 / v
                      : MISTAKE == 3 ? 1.0 / p
                      : MISTAKE == 5 ? 0.5 * sqrt(v)
                                     : v);
    return (float)w;
}
