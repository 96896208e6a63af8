// Calls no other step; the azimuth is drawn first.
#include "photonlab.h"

bool scatter_glossy_phong(Vec3 direction, Vec3 normal, float exponent, Rng *rng, Vec3 *out, float *weight)
{
    float turn = 2.0f * PI * rng_float(rng);
    float z = powf(1.0f - rng_float(rng), 1.0f / (exponent + 1.0f));
    float r = sqrtf(fmaxf(0.0f, 1.0f - z * z));
    Vec3 mirror = vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
    Frame frame = frame_about(mirror);
    *out = frame_to_world(&frame, vec3(r * cosf(turn), r * sinf(turn), z));
    float up = vec3_dot(*out, normal);
    *weight = up * (1.0f + 1.0f / (exponent + 1.0f));
    return up > 0.0f;
}
