// Step 4.3: the sum over the hemisphere. Contract: lib/steps/4_final_gathering.h
#include "photonlab.h"

Colour gather_hemisphere(GatherTrace *trace, const Hit *hit, Hemisphere *seen, Rng *rng)
{
    todo("4.3"), (void)trace, (void)hit, (void)seen, (void)rng; // take this line away when you start

    // 1. Go through the cells, ring by ring.

    // 2. Send a ray through the cell, turned to stand about the normal.

    // 3. Keep what it brings, and how far it went.

    // 4. The cosine is in the density already: what is left of cosθ/pdf is π.

    return colour(0, 0, 0);
}
