#include "photonlab.h"

// The wavelength's square once, the terms by pointers.
float index_at_wavelength(const Material *glass, float wavelength)
{
    float um = wavelength * 0.001f;
    double um2 = (double)um * um, n2 = 1.0;
    if (!glass->sellmeier) {
        n2 = glass->cauchy[1] / um2;
        return (float)(n2 + glass->cauchy[0]);
    }
    const double *c = glass->sellmeier->c;
    for (const double *b = glass->sellmeier->b; b < glass->sellmeier->b + SELLMEIER_TERMS; b++, c++)
        n2 += *b * um2 / (um2 - *c);
    return (float)sqrt(n2);
}
