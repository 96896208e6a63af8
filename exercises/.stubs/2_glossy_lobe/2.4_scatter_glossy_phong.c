// Step 2.4: the glossy bounce of the modified Phong BRDF. Contract: lib/steps/2_glossy_lobe.h
#include "photonlab.h"

bool scatter_glossy_phong(Vec3 direction, Vec3 normal, float exponent, Rng *rng, Vec3 *out, float *weight)
{
    todo("2.4"), (void)direction, (void)exponent, (void)rng; // take this line away when you start

    // 1. Draw one lobe sample about the mirror direction.

    // 2. What points into the surface is absorbed.

    // 3. Weigh it by BRDF times cosine over density.

    *out = normal;
    *weight = 1.0f;
    return true;
}
