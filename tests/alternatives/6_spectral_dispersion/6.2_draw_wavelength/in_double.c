#include "photonlab.h"

float draw_wavelength(float u, float *weight)
{
    const double m = WAVELENGTH_MIDDLE, s = WAVELENGTH_SPREAD;
    double first = tanh((WAVELENGTH_FIRST - m) / s), last = tanh((WAVELENGTH_LAST - m) / s);
    double wavelength = m + s * atanh((1.0 - u) * first + u * last);
    double c = cosh((wavelength - m) / s);
    *weight = (float)(s * (last - first) * c * c / WAVELENGTH_RANGE);
    return (float)wavelength;
}
