// Step 1.3: a diffuse bounce. Contract: lib/steps/1_diffuse_photon_map.h
#include "photonlab.h"

Vec3 scatter_diffuse(Vec3 normal, Rng *rng)
{
    todo("1.3"), (void)rng; // take this line away when you start

    // 1. Draw the angle to the normal by inverting the cosine density, and the angle about it uniformly.

    // 2. Write the direction in coordinates whose z axis is the normal, and turn it to the world's.

    return normal;
}
