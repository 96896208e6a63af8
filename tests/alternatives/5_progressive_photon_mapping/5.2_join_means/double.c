// In double precision, channel by channel.
#include "photonlab.h"

static float join(float a, int m, float b, int n)
{
    return (float)(((double)m * (double)a + (double)n * (double)b) / ((double)m + (double)n));
}

Colour join_means(Colour a, int m, Colour b, int n)
{
    return colour(join(a.r, m, b.r, n), join(a.g, m, b.g, n), join(a.b, m, b.b, n));
}
