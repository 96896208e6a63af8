// Calls no other step.
#include "photonlab.h"

static Vec3 about(Vec3 axis, float cosine, Rng *rng)
{
    float turn = 2.0f * PI * rng_float(rng);
    float sine = sqrtf(fmaxf(0.0f, 1.0f - cosine * cosine));
    Frame frame = frame_about(axis);
    return frame_to_world(&frame, vec3(sine * cosf(turn), sine * sinf(turn), cosine));
}

bool scatter_glossy_source_text(Vec3 direction, Vec3 normal, float exponent, Rng *rng, Vec3 *out, float *weight)
{
    *weight = 1.0f;
    Vec3 mirror = vec3_sub(direction, vec3_scale(normal, 2.0f * vec3_dot(normal, direction)));
    float u = rng_float(rng);
    *out = about(normal, sqrtf(1.0f - u), rng);
    if (vec3_dot(*out, mirror) > 0.0f) {
        int i = 0;
        do {
            if (i++ == MAX_LOBE_TRIES) {
                redraw_cap_reached();
                return false;
            }
            u = rng_float(rng);
            *out = about(mirror, powf(1.0f - u, 1.0f / (exponent + 1.0f)), rng);
        } while (vec3_dot(*out, normal) <= 0.0f);
    }
    return true;
}
