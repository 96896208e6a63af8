// Step 1.6: radiance from the photons nearby. Contract: lib/steps/1_diffuse_photon_map.h
#include "photonlab.h"

Colour estimate_radiance(const PhotonMap *map, const Hit *hit, Vec3 wo, Gather *gather)
{
    todo("1.6"), (void)map, (void)hit, (void)wo, (void)gather; // take this line away when you start

    // 1. Find the photons near the point, and the radius r of the disk they lie in.

    // 2. Leave out those that arrived on the other side of the surface.

    // 3. Let nearer photons count more: a cone of height 1 over the disk.

    // 4. Add the share of the photon's flux that the surface sends towards the eye. Its cosine is in the flux
    // already.

    // 5. Divide by the cone's volume, πr²/3: flux becomes flux per area.

    return colour(0.0f, 0.0f, 0.0f);
}
