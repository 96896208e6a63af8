// Indirect light changes slowly: where an estimate was made a fraction of its own radius away, its disk of photons is
// nearly the same one. The eye pass keeps the estimates of one tile and shares them (in the spirit of Ward et al.
// 1988).
#ifndef PHOTONLAB_RENDER_IRRADIANCE_CACHE_H
#define PHOTONLAB_RENDER_IRRADIANCE_CACHE_H

#include "math/colour.h"
#include "math/vec3.h"

#include <stdbool.h>
#include <stddef.h>

#define IRRADIANCE_CACHE_ROOM 1024

typedef struct {
    Vec3 position, normal;
    float reach; // m: how far it may be used
    Colour irradiance;
} CachedIrradiance;

typedef struct {
    CachedIrradiance entries[IRRADIANCE_CACHE_ROOM];
    size_t count;
} IrradianceCache;

static inline void irradiance_cache_clear(IrradianceCache *cache)
{
    cache->count = 0;
}

// The mean of the estimates within reach on the same flat piece of surface, weighted by nearness; false when none is
// near enough.
bool irradiance_cache_find(const IrradianceCache *cache, Vec3 position, Vec3 normal, Colour *irradiance);

// When the cache is full the estimate is not kept.
void irradiance_cache_add(IrradianceCache *cache, Vec3 position, Vec3 normal, float reach, Colour irradiance);

#endif
