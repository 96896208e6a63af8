// A point of the unit disk, lifted to the hemisphere above it (Malley).
#include "photonlab.h"

Vec3 gather_direction(int ring, int sector, Rng *rng)
{
    float radius2 = (ring + rng_float(rng)) / GATHER_RINGS;
    float turn = (sector + rng_float(rng)) / GATHER_SECTORS;
    float x = sqrtf(radius2) * cosf(turn * 2.0f * PI);
    float y = sqrtf(radius2) * sinf(turn * 2.0f * PI);
    return vec3(x, y, sqrtf(fmaxf(0.0f, 1.0f - x * x - y * y)));
}
