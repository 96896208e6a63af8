// How the eye pass looks photons up: what step 1.6 is given.
#pragma once

#include "photons/photon_map.h"
#include "scene/scene.h"

typedef struct {
    size_t k;           // photons in an estimate
    float radius;       // none farther than this, m; INFINITY: k alone decides
    GlossyModel glossy; // the BRDF played at glossy surfaces
    NearPhoton *near; // PHOTON_MAP_NEAREST_CAPACITY(k) entries, this thread's own; gather_near fills the first of them
    float reach;      // written by gather_near: the radius of its last estimate
} Gather;

// Finds the photons for an estimate at `point`: gather->near[0 … returned−1]. *radius is the distance to the k-th, or
// gather->radius when fewer than k lie within it (without a limit: the distance to the farthest there is).
size_t gather_near(const PhotonMap *map, Vec3 point, Gather *gather, float *radius);

// f_r(wi, wo) of the surface for a stored photon, 1/sr; quick where it does not depend on directions.
static inline Colour gather_brdf(const Gather *gather, const Hit *hit, const StoredPhoton *photon, Vec3 wo)
{
    if (hit->material->type == MATERIAL_DIFFUSE)
        return colour_scale(hit->material->diffuse, 1.0f / PI);
    return material_brdf(hit->material, gather->glossy, stored_photon_wi(photon), wo, hit->normal);
}
