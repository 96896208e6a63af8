// Where all is open the mean is infinite, and the bound does the rest.
#include "photonlab.h"

float irradiance_reach(const Hemisphere *seen, float shortest, float longest)
{
    const int count = GATHER_RINGS * GATHER_SECTORS;
    float sum = 0.0f;
    for (int i = 0; i < count; i++) {
        float r = seen->distance[i / GATHER_SECTORS][i % GATHER_SECTORS];
        if (r < INFINITY)
            sum += 1.0f / r;
    }
    float reach = (float)count / sum;
    if (!(reach <= longest))
        reach = longest;
    return reach > shortest ? reach : shortest;
}
