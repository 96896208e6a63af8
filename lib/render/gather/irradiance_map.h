// Irradiance kept at photons (Christensen 1999): what a gather ray finds where it ends.
//
// At every eighth photon the irradiance E is estimated once, from all photons near it. A gather ray then takes the E of
// the photons where it ends, instead of an estimate of its own: some hundred rays a point become affordable.
#pragma once

#include "photons/gather.h"

typedef struct IrradianceMap IrradianceMap;

// Irradiance, W/m², and the radius of the disk of photons that it was estimated from, m.
typedef struct {
    Colour irradiance;
    float radius;
} LocalIrradiance;

// At `count` places, each that of a photon, from a map of photons that these are not in: direct ones and caustics
// included, `k` to an estimate (step 1.6 on a white matt surface, E = πL). The same whatever the number of threads. NULL
// when memory is short.
IrradianceMap *irradiance_map_build(const Scene *scene, const PhotonMap *photons, const StoredPhoton *places,
                                    size_t count, size_t k, Error *error);

// The same irradiance everywhere, with no place too near a corner for it: light as it is in a furnace.
IrradianceMap *irradiance_map_uniform(Colour irradiance);
void irradiance_map_free(IrradianceMap *map);
size_t irradiance_map_bytes(const IrradianceMap *map);

// On the side of the surface that `normal` points to. False: no photon with an estimate lies near.
bool irradiance_map_find(const IrradianceMap *map, Vec3 position, Vec3 normal, LocalIrradiance *found);
