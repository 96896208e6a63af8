#include "render/eye.h"

// Step 1.6 without a kernel and without its division: the radius is the point's, and is to shrink (step 5.3).
void point_collect(Eye *eye, const PhotonMap *map, const Hit *hit, Vec3 wo, Colour weight)
{
    float radius;
    size_t near = gather_near(map, hit->position, &eye->gather, &radius);
    Colour sum = colour_grey(0.0f);
    for (size_t i = 0; i < near; i++) {
        const StoredPhoton *photon = eye->gather.near[i].photon;
        if (!stored_photon_on_side(photon, hit->normal))
            continue;
        sum = colour_add(sum, colour_mul(gather_brdf(&eye->gather, hit, photon, wo), photon->power));
        eye->found++;
    }
    eye->flux = colour_add(eye->flux, colour_mul(weight, sum));
}
