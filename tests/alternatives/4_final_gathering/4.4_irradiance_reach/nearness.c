// The mean nearness first, bounded itself.
#include "photonlab.h"

float irradiance_reach(const Hemisphere *seen, float shortest, float longest)
{
    float nearness = 0.0f;
    for (int j = 0; j < GATHER_RINGS; j++) {
        float of_ring = 0.0f;
        for (int k = 0; k < GATHER_SECTORS; k++)
            of_ring += isinf(seen->distance[j][k]) ? 0.0f : 1.0f / seen->distance[j][k];
        nearness += of_ring / GATHER_SECTORS;
    }
    nearness /= GATHER_RINGS;
    nearness = fmaxf(nearness, 1.0f / longest);
    nearness = fminf(nearness, 1.0f / shortest);
    return 1.0f / nearness;
}
