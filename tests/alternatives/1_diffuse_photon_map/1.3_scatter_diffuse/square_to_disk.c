// The square bent to a disk ring by ring (Shirley & Chiu 1997), then lifted.
#include "photonlab.h"

static void to_disk(float a, float b, float *x, float *y)
{
    if (a == 0.0f && b == 0.0f) {
        *x = *y = 0.0f;
        return;
    }
    float r = fabsf(a) > fabsf(b) ? a : b;
    float turn = fabsf(a) > fabsf(b) ? PI / 4.0f * (b / a) : PI / 2.0f - PI / 4.0f * (a / b);
    *x = r * cosf(turn);
    *y = r * sinf(turn);
}

Vec3 scatter_diffuse(Vec3 normal, Rng *rng)
{
    float a = 2.0f * rng_float(rng) - 1.0f;
    float b = 2.0f * rng_float(rng) - 1.0f;
    Vec3 d;
    to_disk(a, b, &d.x, &d.y);
    d.z = sqrtf(fmaxf(0.0f, 1.0f - d.x * d.x - d.y * d.y));
    Frame frame = frame_about(normal);
    return vec3_normalize(frame_to_world(&frame, d));
}
