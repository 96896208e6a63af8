// Step 2.4: the glossy bounce of the modified Phong BRDF. Contract: lib/steps/2_glossy_lobe.h
#include "photonlab.h"

bool scatter_glossy_phong(Vec3 direction, Vec3 normal, float exponent, Rng *rng, Vec3 *out, float *weight)
{
    // BEGIN SOLUTION
    // 1. Draw one lobe sample about the mirror direction.
    Vec3 mirror = steps.reflect(direction, normal);
    Vec3 local = steps.sample_lobe(exponent, rng);
    *out = steps.turn_to(local, mirror);

    // 2. What points into the surface is absorbed.
    float cos_out = vec3_dot(*out, normal);
    if (cos_out <= 0.0f)
        return false;

    // 3. Weigh it by BRDF times cosine over density.
    *weight = (exponent + 2.0f) / (exponent + 1.0f) * cos_out;
    return true;
    // STUB: *out = normal;
    // STUB: *weight = 1.0f;
    // STUB: return true;
    // END SOLUTION
}
