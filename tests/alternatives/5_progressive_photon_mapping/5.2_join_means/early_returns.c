// Where one run has no passes, the other's mean is the answer.
#include "photonlab.h"

Colour join_means(Colour a, int m, Colour b, int n)
{
    if (m == 0)
        return b;
    if (n == 0)
        return a;
    float passes = (float)m + (float)n;
    Colour joined = colour_scale(a, (float)m / passes);
    return colour_add(joined, colour_scale(b, (float)n / passes));
}
