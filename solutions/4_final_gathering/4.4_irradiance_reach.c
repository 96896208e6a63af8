// Step 4.4: how far an estimate reaches. Contract: lib/steps/4_final_gathering.h
#include "photonlab.h"

float irradiance_reach(const Hemisphere *seen, float shortest, float longest)
{
    // BEGIN SOLUTION
    // 1. Sum the inverse distances. A ray into the open adds 0.
    float sum = 0.0f;
    for (int j = 0; j < GATHER_RINGS; j++)
        for (int k = 0; k < GATHER_SECTORS; k++)
            sum += 1.0f / seen->distance[j][k];

    // 2. Their harmonic mean, within its bounds. Where all is open, it has none of its own.
    float mean = sum > 0.0f ? GATHER_RINGS * GATHER_SECTORS / sum : longest;
    return fminf(fmaxf(mean, shortest), longest);
    // STUB: return shortest;
    // END SOLUTION
}
