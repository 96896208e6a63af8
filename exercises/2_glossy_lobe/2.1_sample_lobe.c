// Step 2.1: a direction in the cosine lobe about +z. Contract: lib/steps/2_glossy_lobe.h
#include "photonlab.h"

Vec3 sample_lobe(float exponent, Rng *rng)
{
    todo("2.1"), (void)exponent, (void)rng; // take this line away when you start

    // 1. Draw the angle to the axis by inverting the lobe's density. 1 − u is never 0, so its logarithm is finite.

    // 2. Draw the angle about the axis uniformly.

    return vec3(0.0f, 0.0f, 1.0f);
}
