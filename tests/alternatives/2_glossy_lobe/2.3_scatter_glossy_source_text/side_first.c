// Decides the side first: a diffuse direction lies on the mirror direction's side with probability (1 + cosθ)/2.
#include "photonlab.h"

static bool draw(bool lobe, Vec3 mirror, Vec3 normal, float exponent, Rng *rng, Vec3 *out)
{
    for (int i = 0; i < MAX_LOBE_TRIES; i++) {
        Vec3 d = lobe ? steps.turn_to(steps.sample_lobe(exponent, rng), mirror) : steps.scatter_diffuse(normal, rng);
        bool fits = lobe ? vec3_dot(d, normal) > 0.0f : vec3_dot(d, mirror) <= 0.0f;
        *out = d;
        if (fits)
            return true;
    }
    return false;
}

bool scatter_glossy_source_text(Vec3 direction, Vec3 normal, float exponent, Rng *rng, Vec3 *out, float *weight)
{
    Vec3 mirror = steps.reflect(direction, normal);
    float share = 0.5f + 0.5f * vec3_dot(mirror, normal);
    bool lobe = rng_float(rng) < share;
    *weight = 1.0f;
    if (draw(lobe, mirror, normal, exponent, rng, out))
        return true;
    redraw_cap_reached();
    return false;
}
