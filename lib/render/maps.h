// What the eye pass looks up: made of photons before the first eye ray.
#pragma once

#include "render/gather/irradiance_map.h"
#include "render/render.h"

typedef struct {
    PhotonMap *caustic;  // PHOTONS, GATHER
    PhotonMap *rest;     // PHOTONS: indirect; PHOTONS_ONLY, GATHER: all
    IrradianceMap *ends; // GATHER: light where gather rays end
} Maps;

// Runs the photon pass, and adds to `stats` what it did; ledger and map_bytes are of this pass alone. False when memory is short; maps_free is due in any case.
bool maps_make(const Scene *scene, const RenderOptions *options, Maps *maps, RenderStats *stats, Error *error);
void maps_free(Maps *maps);
