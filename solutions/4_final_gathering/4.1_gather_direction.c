// Step 4.1: the direction of a gather ray, one for each cell of the hemisphere. Contract: lib/steps/4_final_gathering.h
#include "photonlab.h"

Vec3 gather_direction(int ring, int sector, Rng *rng)
{
    // BEGIN SOLUTION
    // 1. Draw a place within the cell: first across the ring, then along it.
    float u = rng_float(rng);
    float v = rng_float(rng);

    // 2. Rings of equal share of the cosine have equal steps of sin²θ.
    float sin2 = ((float)ring + u) / GATHER_RINGS;
    float phi = 2.0f * PI * ((float)sector + v) / GATHER_SECTORS;

    // 3. Make a direction of the two angles.
    float sine = sqrtf(sin2);
    return vec3(sine * cosf(phi), sine * sinf(phi), sqrtf(1.0f - sin2));
    // STUB: return vec3(0, 0, 1);
    // END SOLUTION
}
