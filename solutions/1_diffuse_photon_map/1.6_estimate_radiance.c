// Step 1.6: radiance from the photons nearby. Contract: lib/steps/1_diffuse_photon_map.h
#include "photonlab.h"

Colour estimate_radiance(const PhotonMap *map, const Hit *hit, Vec3 wo, Gather *gather)
{
    // BEGIN SOLUTION
    // 1. Find the photons near the point, and the radius r of the disk they lie in.
    float r;
    size_t found = gather_near(map, hit->position, gather, &r);
    if (found == 0 || r <= 0.0f)
        return colour_grey(0.0f);

    Colour sum = colour_grey(0.0f);
    for (size_t i = 0; i < found; i++) {
        const StoredPhoton *photon = gather->near[i].photon;

        // 2. Leave out those that arrived on the other side of the surface.
        if (!stored_photon_on_side(photon, hit->normal))
            continue;

        // 3. Let nearer photons count more: a cone of height 1 over the disk.
        float weight = 1.0f - sqrtf(gather->near[i].distance2) / r;

        // 4. Add the share of the photon's flux that the surface sends towards the eye. Its cosine is in the flux
        // already.
        Colour f = gather_brdf(gather, hit, photon, wo);
        sum = colour_add(sum, colour_scale(colour_mul(f, photon->power), weight));
    }

    // 5. Divide by the cone's volume, πr²/3: flux becomes flux per area.
    return colour_scale(sum, 3.0f / (PI * r * r));
    // STUB: return colour(0.0f, 0.0f, 0.0f);
    // END SOLUTION
}
