#include "photonlab.h"

// All in float, with the terms as b/(1 − c/λ²).
float index_at_wavelength(const Material *glass, float wavelength)
{
    float inverse = 1e6f / (wavelength * wavelength);
    if (glass->sellmeier == NULL)
        return glass->cauchy[0] + glass->cauchy[1] * inverse;
    float n2 = 1.0f;
    for (int i = 0; i < SELLMEIER_TERMS; i++)
        n2 += (float)glass->sellmeier->b[i] / (1.0f - (float)glass->sellmeier->c[i] * inverse);
    return sqrtf(n2);
}
