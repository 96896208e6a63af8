// Step 5.3: a point's statistics after a pass. Contract: lib/steps/5_progressive_photon_mapping.h
#include "photonlab.h"

PointStatistics add_photons(PointStatistics point, int found, Colour flux, float alpha)
{
    todo("5.3"), (void)found, (void)flux, (void)alpha; // take this line away when you start

    // 1. A pass that has found nothing tells nothing.

    // 2. Of the new photons a share stays: by how much has the disk's area to shrink for it?

    // 3. What is left of count, radius and flux.

    return point;
}
