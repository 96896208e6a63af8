// The other number first, and each counted from the other end of its cell.
#include "photonlab.h"

Vec3 gather_direction(int ring, int sector, Rng *rng)
{
    float v = 1.0f - rng_float(rng);
    float u = 1.0f - rng_float(rng);
    float phi = ((float)sector + v) * (2.0f * PI / GATHER_SECTORS);
    float cos2 = ((float)(GATHER_RINGS - ring) - u) / GATHER_RINGS;
    float sine = sqrtf(1.0f - cos2);
    return vec3_normalize(vec3(cosf(phi) * sine, sinf(phi) * sine, sqrtf(fmaxf(cos2, 0.0f))));
}
