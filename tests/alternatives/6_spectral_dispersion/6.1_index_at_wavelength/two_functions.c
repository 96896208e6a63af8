#include "photonlab.h"

static double sellmeier(const SellmeierGlass *glass, double micrometres)
{
    double sum = 0.0;
    for (int i = SELLMEIER_TERMS - 1; i >= 0; i--)
        sum += glass->b[i] * pow(micrometres, 2.0) / (pow(micrometres, 2.0) - glass->c[i]);
    return sqrt(sum + 1.0);
}

static double cauchy(const float terms[2], double micrometres)
{
    return (double)terms[0] + (double)terms[1] / micrometres / micrometres;
}

float index_at_wavelength(const Material *glass, float wavelength)
{
    double micrometres = (double)wavelength / 1000.0;
    return (float)(glass->sellmeier ? sellmeier(glass->sellmeier, micrometres) : cauchy(glass->cauchy, micrometres));
}
