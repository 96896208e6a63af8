// A loop over the channels.
#include "photonlab.h"

Colour join_means(Colour a, int m, Colour b, int n)
{
    Colour mean = a;
    for (int c = 0; c < 3; c++) {
        double sum = (double)colour_channel(a, c) * m;
        sum += (double)colour_channel(b, c) * n;
        colour_set_channel(&mean, c, (float)(sum / (m + n)));
    }
    return mean;
}
