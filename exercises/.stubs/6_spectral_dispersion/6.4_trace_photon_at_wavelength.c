// Step 6.4: the life of a photon of one wavelength. Contract: lib/steps/6_spectral_dispersion.h
#include "photonlab.h"

// Glass: reflected or refracted, at the photon's own index. Whole, as nothing splits.
static Vec3 turn_at_glass(const Photon *photon, const Hit *hit, Rng *rng)
{
    (void)hit, (void)rng; // take this line away when you start

    // 4. The index of its one wavelength, on the way in as on the way out.

    // 5. Through, or back. Its power stays: each way is taken as often as it should be.

    return photon->direction;
}

void trace_photon_at_wavelength(PhotonTrace *trace, Photon photon, Rng *rng)
{
    todo("6.4"), (void)turn_at_glass, (void)trace, (void)photon, (void)rng; // take this line away when you start

    // 1. Fly from surface to surface. What each is at this wavelength?

    // 2. Leave a copy on a rough surface.

    // 3. Do what the material does, as in 1.5 or 3.4, but with the reflectances at this wavelength.

    // 6. Fly on from here.
}
