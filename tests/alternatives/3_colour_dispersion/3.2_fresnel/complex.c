// With complex numbers total reflection needs no case of its own: the cosine becomes imaginary.
#include "photonlab.h"

#include <complex.h>

float fresnel(float cos_i, float eta)
{
    double complex cos_t = csqrt(1.0 - (double)eta * (double)eta * (1.0 - (double)cos_i * (double)cos_i));
    double complex r_s = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    double complex r_p = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    double a = cabs(r_s);
    double b = cabs(r_p);
    return (float)fmin(1.0, 0.5 * (a * a + b * b));
}
