// Step 4.4: how far an estimate reaches. Contract: lib/steps/4_final_gathering.h
#include "photonlab.h"

float irradiance_reach(const Hemisphere *seen, float shortest, float longest)
{
    todo("4.4"), (void)seen, (void)longest; // take this line away when you start

    // 1. Sum the inverse distances. A ray into the open adds 0.

    // 2. Their harmonic mean, within its bounds. Where all is open, it has none of its own.

    return shortest;
}
