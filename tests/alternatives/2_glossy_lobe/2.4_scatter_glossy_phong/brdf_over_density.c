// The weight to the letter: BRDF times cosine over density.
#include "photonlab.h"

bool scatter_glossy_phong(Vec3 direction, Vec3 normal, float exponent, Rng *rng, Vec3 *out, float *weight)
{
    Vec3 local = steps.sample_lobe(exponent, rng);
    *out = steps.turn_to(local, steps.reflect(direction, normal));
    double cosine = vec3_dot(*out, normal);
    double lobe = pow((double)fmaxf(local.z, 1e-6f), (double)exponent);
    double brdf = ((double)exponent + 2.0) / (2.0 * (double)PI) * lobe;
    double density = ((double)exponent + 1.0) / (2.0 * (double)PI) * lobe;
    if (!(cosine > 0.0))
        return false;
    *weight = density > 0.0 ? (float)(brdf * cosine / density) : 0.0f;
    return true;
}
