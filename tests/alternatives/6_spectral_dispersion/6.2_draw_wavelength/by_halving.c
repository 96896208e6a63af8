#include "photonlab.h"

// Looks for the wavelength whose share is u, instead of inverting.
float draw_wavelength(float u, float *weight)
{
    double m = WAVELENGTH_MIDDLE, s = WAVELENGTH_SPREAD, low = WAVELENGTH_FIRST, high = WAVELENGTH_LAST;
    double first = tanh((low - m) / s), whole = tanh((high - m) / s) - first;
    for (int i = 0; i < 60; i++) {
        double middle = 0.5 * (low + high);
        if (tanh((middle - m) / s) - first < u * whole)
            low = middle;
        else
            high = middle;
    }
    double t = tanh((low - m) / s);
    *weight = (float)(s * whole / (1.0 - t * t) / WAVELENGTH_RANGE);
    return (float)low;
}
