// Fresnel's own form, with sines and tangents of sum and difference of the angles.
#include "photonlab.h"

float fresnel(float cos_i, float eta)
{
    double i = acos(fmin(1.0, (double)cos_i));
    double sin_t = (double)eta * sin(i);
    if (sin_t >= 1.0)
        return 1.0f;
    double t = asin(sin_t);
    if (i < 1e-4) {
        double r = ((double)eta - 1.0) / ((double)eta + 1.0);
        return (float)(r * r);
    }
    double s = sin(i - t) / sin(i + t);
    double p = tan(i - t) / tan(i + t);
    return (float)((s * s + p * p) / 2.0);
}
