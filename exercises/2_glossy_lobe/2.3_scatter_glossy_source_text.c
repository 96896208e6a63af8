// Step 2.3: the source text's glossy bounce, gap and lobe. Contract: lib/steps/2_glossy_lobe.h
#include "photonlab.h"

bool scatter_glossy_source_text(Vec3 direction, Vec3 normal, float exponent, Rng *rng, Vec3 *out, float *weight)
{
    todo("2.3"), (void)direction, (void)exponent, (void)rng; // take this line away when you start

    // 1. Draw a diffuse direction. Away from the mirror direction it stays: this is the gap's other side.

    // 2. Otherwise take a lobe sample about the mirror direction, redrawn while it points into the surface.

    // 3. Never loop for ever: say that the cap was hit.

    *out = normal;
    *weight = 1.0f;
    return true;
}
