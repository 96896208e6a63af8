// Step 5.3: a point's statistics after a pass. Contract: lib/steps/5_progressive_photon_mapping.h
#include "photonlab.h"

PointStatistics add_photons(PointStatistics point, int found, Colour flux, float alpha)
{
    // BEGIN SOLUTION
    // 1. A pass that has found nothing tells nothing.
    if (found == 0)
        return point;

    // 2. Of the new photons a share stays: by how much has the disk's area to shrink for it?
    float kept = point.count + alpha * (float)found;
    float share = kept / (point.count + (float)found);

    // 3. What is left of count, radius and flux.
    return (PointStatistics){
        .count = kept,
        .radius = point.radius * sqrtf(share),
        .flux = colour_scale(colour_add(point.flux, flux), share),
    };
    // STUB: return point;
    // END SOLUTION
}
