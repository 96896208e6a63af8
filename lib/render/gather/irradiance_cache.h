// Irradiance caching (Ward, Rubinstein & Clear 1988): indirect light changes slowly, so that an estimate made by hundreds
// of gather rays serves its surroundings. Each estimate knows how far it reaches and how it changes on the way (Ward &
// Heckbert 1992).
#pragma once

#include "photons/irradiance.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct IrradianceCache IrradianceCache;

// `accuracy` a: an estimate serves where its error ε = |x − x_i|/R_i + √(1 − n·n_i) is below a.
IrradianceCache *irradiance_cache_create(float accuracy, float longest_reach);
void irradiance_cache_free(IrradianceCache *cache);
bool irradiance_cache_add(IrradianceCache *cache, const IrradianceEstimate *estimate); // false: no memory
void irradiance_cache_clear(IrradianceCache *cache);

// All of them, in the order of adding.
const IrradianceEstimate *irradiance_cache_estimates(const IrradianceCache *cache, size_t *count);

// The weighted mean of the estimates that serve at this place; false: none does.
bool irradiance_cache_find(const IrradianceCache *cache, Vec3 position, Vec3 normal, Colour *irradiance);
