// Step 4.3: the sum over the hemisphere. Contract: lib/steps/4_final_gathering.h
#include "photonlab.h"

Colour gather_hemisphere(GatherTrace *trace, const Hit *hit, Hemisphere *seen, Rng *rng)
{
    // BEGIN SOLUTION
    Colour sum = colour_grey(0.0f);
    Frame frame = frame_about(hit->normal);

    // 1. Go through the cells, ring by ring.
    for (int j = 0; j < GATHER_RINGS; j++)
        for (int k = 0; k < GATHER_SECTORS; k++) {
            // 2. Send a ray through the cell, turned to stand about the normal.
            Vec3 direction = frame_to_world(&frame, steps.gather_direction(j, k, rng));
            Ray ray = {hit->position, direction, hit->primitive};

            // 3. Keep what it brings, and how far it went.
            seen->radiance[j][k] = gather_send(trace, ray, rng);
            seen->distance[j][k] = gather_distance(trace);
            sum = colour_add(sum, seen->radiance[j][k]);
        }

    // 4. The cosine is in the density already: what is left of cosθ/pdf is π.
    return colour_scale(sum, PI / (GATHER_RINGS * GATHER_SECTORS));
    // STUB: return colour(0, 0, 0);
    // END SOLUTION
}
