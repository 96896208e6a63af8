// Step 5.4: the radiance of a point, by its statistics. Contract: lib/steps/5_progressive_photon_mapping.h
#include "photonlab.h"

Colour point_radiance(PointStatistics point, int passes)
{
    todo("5.4"), (void)point, (void)passes; // take this line away when you start

    // 1. Flux per area of the disk, and of one pass.

    return colour(0, 0, 0);
}
