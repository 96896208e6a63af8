// The first mean moves towards the second.
#include "photonlab.h"

Colour join_means(Colour a, int m, Colour b, int n)
{
    float share = (float)n / (float)(m + n);
    Colour apart = colour_sub(b, a);
    return colour_add(a, colour_scale(apart, share));
}
