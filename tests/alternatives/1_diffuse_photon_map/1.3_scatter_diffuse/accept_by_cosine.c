// Uniform directions above the surface, kept with a probability of their cosine.
#include "photonlab.h"

static Vec3 anywhere(Rng *rng)
{
    for (;;) {
        float x = 2.0f * rng_float(rng) - 1.0f;
        float y = 2.0f * rng_float(rng) - 1.0f;
        float z = 2.0f * rng_float(rng) - 1.0f;
        float r2 = x * x + y * y + z * z;
        if (r2 > 1e-4f && r2 <= 1.0f)
            return vec3_scale(vec3(x, y, z), 1.0f / sqrtf(r2));
    }
}

Vec3 scatter_diffuse(Vec3 normal, Rng *rng)
{
    for (;;) {
        Vec3 d = anywhere(rng);
        float cosine = vec3_dot(d, normal);
        if (cosine < 0.0f) {
            d = vec3_negate(d);
            cosine = -cosine;
        }
        if (rng_float(rng) < cosine)
            return d;
    }
}
