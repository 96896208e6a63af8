// A direction in the first sector, turned into its own.
#include "photonlab.h"

Vec3 gather_direction(int ring, int sector, Rng *rng)
{
    float r[2];
    for (int i = 0; i < 2; i++)
        r[i] = rng_float(rng);
    float width = 2.0f * PI / (float)GATHER_SECTORS;
    float height = sqrtf(1.0f - ((float)ring + r[0]) * (1.0f / GATHER_RINGS));
    float out = sqrtf(1.0f - height * height);
    float x = out * cosf(r[1] * width), y = out * sinf(r[1] * width);
    float c = cosf((float)sector * width), s = sinf((float)sector * width);
    return vec3(x * c - y * s, x * s + y * c, height);
}
