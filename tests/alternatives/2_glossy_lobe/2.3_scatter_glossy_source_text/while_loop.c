// Counts tries down, with a helper for one of them.
#include "photonlab.h"

static Vec3 lobe_about(Vec3 axis, float exponent, Rng *rng)
{
    return steps.turn_to(steps.sample_lobe(exponent, rng), axis);
}

bool scatter_glossy_source_text(Vec3 direction, Vec3 normal, float exponent, Rng *rng, Vec3 *out, float *weight)
{
    const Vec3 ideal = steps.reflect(direction, normal);
    Vec3 candidate = steps.scatter_diffuse(normal, rng);
    int tries_left = MAX_LOBE_TRIES;
    if (vec3_dot(ideal, candidate) > 0.0f) {
        candidate = lobe_about(ideal, exponent, rng);
        while (vec3_dot(normal, candidate) <= 0.0f && --tries_left > 0)
            candidate = lobe_about(ideal, exponent, rng);
    }
    *out = candidate;
    *weight = 1.0f;
    if (tries_left > 0)
        return true;
    redraw_cap_reached();
    return false;
}
