// Step 5.1: the radius of the next pass. Contract: lib/steps/5_progressive_photon_mapping.h
#include "photonlab.h"

float next_radius(float radius, int pass, float alpha)
{
    // BEGIN SOLUTION
    // 1. By what share is the disk's area smaller?
    float share = ((float)pass + alpha) / ((float)pass + 1.0f);

    // 2. The radius goes with the root of the area.
    return radius * sqrtf(share);
    // STUB: return radius;
    // END SOLUTION
}
