// Step 5.4: the radiance of a point, by its statistics. Contract: lib/steps/5_progressive_photon_mapping.h
#include "photonlab.h"

Colour point_radiance(PointStatistics point, int passes)
{
    // BEGIN SOLUTION
    // 1. Flux per area of the disk, and of one pass.
    float area = PI * point.radius * point.radius;
    return colour_scale(point.flux, 1.0f / ((float)passes * area));
    // STUB: return colour(0, 0, 0);
    // END SOLUTION
}
