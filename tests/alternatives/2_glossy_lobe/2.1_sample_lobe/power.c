// The root by powf, the sine by Pythagoras.
#include "photonlab.h"

Vec3 sample_lobe(float exponent, Rng *rng)
{
    float u = rng_float(rng);
    float v = rng_float(rng);
    float z = powf(u, 1.0f / (1.0f + exponent));
    float r = sqrtf(fmaxf(0.0f, (1.0f - z) * (1.0f + z)));
    float turn = PI * (2.0f * v - 1.0f);
    return vec3(r * cosf(turn), r * sinf(turn), z);
}
