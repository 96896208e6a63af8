// Step 1.5: the life of a photon, as a loop. Contract: lib/steps/1_diffuse_photon_map.h
#include "photonlab.h"

void trace_photon(PhotonTrace *trace, Photon photon, Rng *rng)
{
    todo("1.5"), (void)trace, (void)photon, (void)rng; // take this line away when you start

    // 1. Fly from surface to surface until the path ends.

    // 2. Leave a copy where it lands on a rough surface, with the power it arrives with.

    // 3. Do what the material does: survive and take a new direction, or end here.

    // 4. Fly on from here.
}
