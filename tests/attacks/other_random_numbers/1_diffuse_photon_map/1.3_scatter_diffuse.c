// Right, but with random numbers that are not the program's.
#include "photonlab.h"

#include <stdlib.h>

Vec3 scatter_diffuse(Vec3 normal, Rng *rng)
{
    (void)rng;
    float u1 = (float)rand() / ((float)RAND_MAX + 1.0f);
    float phi = 2.0f * PI * (float)rand() / ((float)RAND_MAX + 1.0f);
    Frame frame = frame_about(normal);
    return frame_to_world(&frame, vec3(sqrtf(1.0f - u1) * cosf(phi), sqrtf(1.0f - u1) * sinf(phi), sqrtf(u1)));
}
