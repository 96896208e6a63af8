// Redraws by recursion.
#include "photonlab.h"

static bool try_lobe(Vec3 axis, Vec3 normal, float exponent, Rng *rng, int tries, Vec3 *out)
{
    if (tries == 0)
        return false;
    Vec3 local = steps.sample_lobe(exponent, rng);
    *out = steps.turn_to(local, axis);
    return vec3_dot(*out, normal) > 0.0f || try_lobe(axis, normal, exponent, rng, tries - 1, out);
}

bool scatter_glossy_source_text(Vec3 direction, Vec3 normal, float exponent, Rng *rng, Vec3 *out, float *weight)
{
    bool ok = true;
    Vec3 axis = steps.reflect(direction, normal);
    Vec3 diffuse = steps.scatter_diffuse(normal, rng);
    bool in_gap = vec3_dot(diffuse, axis) <= 0.0f;
    if (in_gap)
        *out = diffuse;
    else
        ok = try_lobe(axis, normal, exponent, rng, MAX_LOBE_TRIES, out);
    if (!ok)
        redraw_cap_reached();
    *weight = 1.0f;
    return ok;
}
