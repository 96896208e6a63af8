// The normal plus a point of the unit sphere: a chord's direction has the cosine's density.
#include "photonlab.h"

Vec3 scatter_diffuse(Vec3 normal, Rng *rng)
{
    Vec3 sum = normal;
    do {
        float turn = 2.0f * PI * rng_float(rng);
        float z = 1.0f - 2.0f * rng_float(rng);
        float r = sqrtf(1.0f - z * z);
        sum = vec3_add(normal, vec3(r * cosf(turn), r * sinf(turn), z));
    } while (vec3_dot(sum, sum) < 1e-6f);
    return vec3_normalize(sum);
}
