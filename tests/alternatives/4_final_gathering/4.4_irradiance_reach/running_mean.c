// A mean of 1/r that grows ray by ray.
#include "photonlab.h"

float irradiance_reach(const Hemisphere *seen, float shortest, float longest)
{
    float mean = 0.0f;
    int n = 0;
    for (int j = 0; j < GATHER_RINGS; j++)
        for (int k = 0; k < GATHER_SECTORS; k++)
            mean += (powf(seen->distance[j][k], -1.0f) - mean) / (float)++n;
    return mean * longest <= 1.0f ? longest : fmaxf(shortest, 1.0f / mean);
}
