#include "photonlab.h"

static float T(float wavelength)
{
    return tanhf((wavelength - WAVELENGTH_MIDDLE) / WAVELENGTH_SPREAD);
}

static float density(float wavelength)
{
    float c = coshf((wavelength - WAVELENGTH_MIDDLE) / WAVELENGTH_SPREAD);
    return 1.0f / (WAVELENGTH_SPREAD * (T(WAVELENGTH_LAST) - T(WAVELENGTH_FIRST)) * c * c);
}

float draw_wavelength(float u, float *weight)
{
    float start = T(WAVELENGTH_FIRST);
    float end = T(WAVELENGTH_LAST);
    float wavelength = WAVELENGTH_MIDDLE + WAVELENGTH_SPREAD * atanhf(start + u * (end - start));
    *weight = 1.0f / density(wavelength) / WAVELENGTH_RANGE;
    return wavelength;
}
