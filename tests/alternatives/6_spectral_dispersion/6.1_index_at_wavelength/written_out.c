#include "photonlab.h"

float index_at_wavelength(const Material *glass, float wavelength)
{
    const double l2 = (double)wavelength * (double)wavelength * 1e-6;
    if (glass->sellmeier) {
        const double *b = glass->sellmeier->b, *c = glass->sellmeier->c;
        double n2 = 1.0 + l2 * (b[0] / (l2 - c[0]) + b[1] / (l2 - c[1]) + b[2] / (l2 - c[2]));
        return (float)pow(n2, 0.5);
    }
    return (float)((double)glass->cauchy[0] + (double)glass->cauchy[1] / l2);
}
