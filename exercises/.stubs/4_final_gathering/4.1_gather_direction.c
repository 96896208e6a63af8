// Step 4.1: the direction of a gather ray, one for each cell of the hemisphere. Contract: lib/steps/4_final_gathering.h
#include "photonlab.h"

Vec3 gather_direction(int ring, int sector, Rng *rng)
{
    todo("4.1"), (void)ring, (void)sector, (void)rng; // take this line away when you start

    // 1. Draw a place within the cell: first across the ring, then along it.

    // 2. Rings of equal share of the cosine have equal steps of sin²θ.

    // 3. Make a direction of the two angles.

    return vec3(0, 0, 1);
}
