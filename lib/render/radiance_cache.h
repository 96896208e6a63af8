// Indirect light changes slowly: where an estimate was made a fraction of its own radius away, its disk of photons is
// nearly the same one. The eye pass keeps the estimates of one tile for matt surfaces, which look the same from
// everywhere, and shares them (in the spirit of Ward et al. 1988).
#pragma once

#include "math/colour.h"
#include "math/vec3.h"

#include <stdbool.h>
#include <stddef.h>

#define RADIANCE_CACHE_CAPACITY 1024

typedef struct {
    Vec3 position, normal;
    const void *material; // shared only by surfaces of the same one
    float reach;          // m: how far it may be used
    Colour radiance;      // W/(m²·sr)
} CachedRadiance;

typedef struct {
    CachedRadiance entries[RADIANCE_CACHE_CAPACITY];
    size_t count;
} RadianceCache;

static inline void radiance_cache_clear(RadianceCache *cache)
{
    cache->count = 0;
}

// The mean of the estimates within reach on the same flat piece of surface, weighted by nearness; false when none is
// near enough.
bool radiance_cache_find(const RadianceCache *cache, Vec3 position, Vec3 normal, const void *material,
                         Colour *radiance);

// When the cache is full the estimate is not kept.
void radiance_cache_add(RadianceCache *cache, const CachedRadiance *entry);
