// Photon map: photons at rest, in a balanced kd-tree that finds those near a point (Jensen 1996; Bentley 1975).
// Usable alone: needs nothing of a scene.
//
//   PhotonMap *map = photon_map_build(photons, count, &error);   // takes the array over and reorders it
//   NearPhoton near[PHOTON_MAP_NEAREST_CAPACITY(50)];
//   float radius2 = 0.1f * 0.1f;
//   size_t found = photon_map_nearest(map, point, 50, &radius2, near);
//   …
//   photon_map_free(map);
#pragma once

#include "base/error.h"
#include "photons/photon.h"

#include <stddef.h>

typedef struct PhotonMap PhotonMap;

typedef struct {
    const StoredPhoton *photon; // points into the map
    float distance2;            // squared distance to the query point, m²
} NearPhoton;

// Takes ownership of `photons` (from malloc; freed by photon_map_free, and also when building fails) and sorts it in
// place into the tree's order. The same order whatever the number of threads. count may be 0. At most 40 bytes a
// photon in all. While it builds, 4 bytes a photon more. NULL when memory is short or a coordinate is not finite or
// beyond 1e18 m.
PhotonMap *photon_map_build(StoredPhoton *photons, size_t count, Error *error);
void photon_map_free(PhotonMap *map);

// The up to k photons nearest to `point` among those with distance² < *radius2 (INFINITY: no limit), in no particular
// order. Returns how many. If k were found, *radius2 becomes the squared distance of the farthest of them (the k-th);
// otherwise *radius2 stays. `near` must hold PHOTON_MAP_NEAREST_CAPACITY(k) entries: the search uses the rest as scratch.
size_t photon_map_nearest(const PhotonMap *map, Vec3 point, size_t k, float *radius2, NearPhoton *near);
#define PHOTON_MAP_NEAREST_CAPACITY(k) (2 * (k) + 64)
#define PHOTON_MAP_NEAREST_ROOM        PHOTON_MAP_NEAREST_CAPACITY // its name in earlier handouts

size_t photon_map_count(const PhotonMap *map);
const StoredPhoton *photon_map_photons(const PhotonMap *map); // all of them, in the tree's order
size_t photon_map_bytes(const PhotonMap *map);                // photons and index together
