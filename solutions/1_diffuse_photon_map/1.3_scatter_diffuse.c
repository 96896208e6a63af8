// Step 1.3: a diffuse bounce. Contract: lib/steps/1_diffuse_photon_map.h
#include "photonlab.h"

Vec3 scatter_diffuse(Vec3 normal, Rng *rng)
{
    // BEGIN SOLUTION
    // 1. Draw the angle to the normal by inverting the cosine density, and the angle about it uniformly.
    float u1 = rng_float(rng);
    float u2 = rng_float(rng);
    float cos_theta = sqrtf(u1);
    float sin_theta = sqrtf(1.0f - u1);
    float phi = 2.0f * PI * u2;

    // 2. Write the direction in coordinates whose z axis is the normal, and turn it to the world's.
    Frame frame = frame_about(normal);
    return frame_to_world(&frame, vec3(sin_theta * cosf(phi), sin_theta * sinf(phi), cos_theta));
    // STUB: return normal;
    // END SOLUTION
}
