// Step 5.1: the radius of the next pass. Contract: lib/steps/5_progressive_photon_mapping.h
#include "photonlab.h"

float next_radius(float radius, int pass, float alpha)
{
    todo("5.1"), (void)pass, (void)alpha; // take this line away when you start

    // 1. By what share is the disk's area smaller?

    // 2. The radius goes with the root of the area.

    return radius;
}
