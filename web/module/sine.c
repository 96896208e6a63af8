// sinf and cosf with the roundings that they have on Linux, in its C library (glibc 2.28 and later, by the polynomials of
// Arm's optimized-routines): WASI's own differ from them in the last bit of one number in eighty, and photons would
// scatter otherwise than the program's do. All else that photons need (expf, logf, powf) is the
// same in both, or stands in logarithm.c.
#include <math.h>

#define HALF_PI 0x1.921FB54442D18p0

// Of x in −π/4…π/4, to the precision of a float.
static double sine(double x)
{
    double x2 = x * x, x3 = x * x2;
    double high = 0x1.1107605230bc4p-7 + x2 * -0x1.994eb3774cf24p-13;
    double low = x + x3 * -0x1.555545995a603p-3;
    return low + x3 * x2 * high;
}

static double cosine(double x)
{
    double x2 = x * x, x4 = x2 * x2;
    double high = -0x1.6c087e89a359dp-10 + x2 * 0x1.99343027bf8c3p-16;
    double low = 1.0 + x2 * -0x1.ffffffd0c621cp-2;
    return low + x4 * 0x1.55553e1068f19p-5 + x4 * x2 * high;
}

// sin(x + quarters·π/2)
static float turned(double x, int quarters)
{
    if (fabs(x) >= 120.0) // infinity, too
        return (float)(quarters ? cos(x) : sin(x));
    int n = fabs(x) < HALF_PI / 2.0 ? 0 : (int)lrint(x / HALF_PI);
    double rest = x - n * HALF_PI;
    int place = (n + quarters) & 3;
    double value = place & 1 ? cosine(rest) : sine(rest);
    return (float)(place & 2 ? -value : value);
}

float sinf(float x)
{
    return turned((double)x, 0);
}

float cosf(float x)
{
    return turned((double)x, 1);
}
