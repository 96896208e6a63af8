// Step 2.3: the source text's glossy bounce, gap and lobe. Contract: lib/steps/2_glossy_lobe.h
#include "photonlab.h"

bool scatter_glossy_source_text(Vec3 direction, Vec3 normal, float exponent, Rng *rng, Vec3 *out, float *weight)
{
    // BEGIN SOLUTION
    *weight = 1.0f;

    // 1. Draw a diffuse direction. Away from the mirror direction it stays: this is the gap's other side.
    Vec3 mirror = steps.reflect(direction, normal);
    *out = steps.scatter_diffuse(normal, rng);
    if (vec3_dot(*out, mirror) <= 0.0f)
        return true;

    // 2. Otherwise take a lobe sample about the mirror direction, redrawn while it points into the surface.
    for (int i = 0; i < MAX_LOBE_TRIES; i++) {
        Vec3 local = steps.sample_lobe(exponent, rng);
        *out = steps.turn_to(local, mirror);
        if (vec3_dot(*out, normal) > 0.0f)
            return true;
    }

    // 3. Never loop for ever: say that the cap was hit.
    redraw_cap_reached();
    return false;
    // STUB: *out = normal;
    // STUB: *weight = 1.0f;
    // STUB: return true;
    // END SOLUTION
}
