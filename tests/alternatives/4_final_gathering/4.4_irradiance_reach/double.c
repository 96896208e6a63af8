// In double precision, and with conditions for the bounds.
#include "photonlab.h"

float irradiance_reach(const Hemisphere *seen, float shortest, float longest)
{
    double inverse = 0.0;
    for (int k = 0; k < GATHER_SECTORS; k++)
        for (int j = 0; j < GATHER_RINGS; j++)
            inverse += 1.0 / (double)seen->distance[j][k];
    if (inverse <= 0.0)
        return longest;
    double mean = (double)(GATHER_RINGS * GATHER_SECTORS) / inverse;
    if (mean > (double)longest)
        return longest;
    return mean < (double)shortest ? shortest : (float)mean;
}
