#include "photonlab.h"

// atanh(t) = ½ log((1 + t)/(1 − t)), tanh(x) = 1 − 2/(e^{2x} + 1).
static float hyperbolic_tangent(float x)
{
    return 1.0f - 2.0f / (expf(2.0f * x) + 1.0f);
}

float draw_wavelength(float u, float *weight)
{
    float first = hyperbolic_tangent((WAVELENGTH_FIRST - WAVELENGTH_MIDDLE) / WAVELENGTH_SPREAD);
    float whole = hyperbolic_tangent((WAVELENGTH_LAST - WAVELENGTH_MIDDLE) / WAVELENGTH_SPREAD) - first;
    float t = first + u * whole;
    *weight = WAVELENGTH_SPREAD * whole / ((1.0f - t) * (1.0f + t) * WAVELENGTH_RANGE);
    return WAVELENGTH_MIDDLE + 0.5f * WAVELENGTH_SPREAD * logf((1.0f + t) / (1.0f - t));
}
