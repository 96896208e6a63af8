// Estimates lie in grids of cells, one grid for each power of two of the radius in which they serve. An estimate is listed
// in every cell that its ball touches, eight at most, so that a look-up reads one cell a grid.
#include "render/gather/irradiance_cache.h"

#include "base/array.h"
#include "math/rng.h"
#include "steps/steps.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define GRIDS 16
#define SLOTS ((size_t)1 << 16)
#define NONE  UINT32_MAX

// In one cell of a grid there are a dozen at most where estimates do not overlap needlessly.
#define MOST_NEAR 256

typedef struct {
    uint32_t estimate, next; // NONE: the end
} Link;

struct IrradianceCache {
    float accuracy, largest; // the coarsest grid's cells, m
    IrradianceEstimate *estimates;
    size_t count, capacity;
    Link *links;
    size_t link_count, link_capacity;
    // By the hash of grid and cell; different cells may share one, and the test of the error tells.
    uint32_t heads[SLOTS];
    bool in_use[GRIDS];
};

IrradianceCache *irradiance_cache_create(float accuracy, float longest_reach)
{
    IrradianceCache *cache = calloc(1, sizeof *cache);
    if (!cache)
        return NULL;
    cache->accuracy = accuracy;
    cache->largest = 2.0f * accuracy * longest_reach;
    irradiance_cache_clear(cache);
    return cache;
}

void irradiance_cache_free(IrradianceCache *cache)
{
    if (!cache)
        return;
    free(cache->estimates);
    free(cache->links);
    free(cache);
}

void irradiance_cache_clear(IrradianceCache *cache)
{
    cache->count = 0;
    cache->link_count = 0;
    memset(cache->heads, 0xff, sizeof cache->heads);
    memset(cache->in_use, 0, sizeof cache->in_use);
}

const IrradianceEstimate *irradiance_cache_estimates(const IrradianceCache *cache, size_t *count)
{
    *count = cache->count;
    return cache->estimates;
}

typedef struct {
    int32_t x, y, z;
} Place;

static Place place_of(Vec3 p, float scale)
{
    return (Place){(int32_t)floorf(p.x * scale), (int32_t)floorf(p.y * scale), (int32_t)floorf(p.z * scale)};
}

static size_t slot_of(int grid, Place place)
{
    uint64_t hash = hash_u64((uint64_t)(uint32_t)place.x << 32 | (uint32_t)place.y);
    return (size_t)hash_u64(hash ^ ((uint64_t)(uint32_t)place.z << 4 | (uint32_t)grid)) % SLOTS;
}

static float cell_of(const IrradianceCache *cache, int grid)
{
    return ldexpf(cache->largest, -grid);
}

static bool add_link(IrradianceCache *cache, size_t slot)
{
    if (!array_reserve(&cache->links, cache->link_count + 1, &cache->link_capacity, sizeof *cache->links))
        return false;
    cache->links[cache->link_count] = (Link){(uint32_t)cache->count, cache->heads[slot]};
    cache->heads[slot] = (uint32_t)cache->link_count++;
    return true;
}

bool irradiance_cache_add(IrradianceCache *cache, const IrradianceEstimate *estimate)
{
    if (!array_reserve(&cache->estimates, cache->count + 1, &cache->capacity, sizeof *cache->estimates))
        return false;
    float radius = cache->accuracy * estimate->reach;
    int grid = 0;
    while (grid + 1 < GRIDS && cell_of(cache, grid + 1) >= 2.0f * radius)
        grid++;
    float scale = 1.0f / cell_of(cache, grid);
    Vec3 corner = vec3(radius, radius, radius);
    Place low = place_of(vec3_sub(estimate->position, corner), scale);
    Place high = place_of(vec3_add(estimate->position, corner), scale);
    for (int32_t x = low.x; x <= high.x; x++)
        for (int32_t y = low.y; y <= high.y; y++)
            for (int32_t z = low.z; z <= high.z; z++)
                if (!add_link(cache, slot_of(grid, (Place){x, y, z})))
                    return false;
    cache->in_use[grid] = true;
    cache->estimates[cache->count++] = *estimate;
    return true;
}

bool irradiance_cache_find(const IrradianceCache *cache, Vec3 position, Vec3 normal, Colour *irradiance)
{
    const IrradianceEstimate *near[MOST_NEAR];
    size_t count = 0;
    for (int grid = 0; grid < GRIDS; grid++) {
        if (!cache->in_use[grid])
            continue;
        Place place = place_of(position, 1.0f / cell_of(cache, grid));
        for (uint32_t l = cache->heads[slot_of(grid, place)]; l != NONE && count < MOST_NEAR;
             l = cache->links[l].next) {
            const IrradianceEstimate *estimate = &cache->estimates[cache->links[l].estimate];
            Vec3 offset = vec3_sub(position, estimate->position);
            float radius = cache->accuracy * estimate->reach;
            if (vec3_dot(offset, offset) < radius * radius && vec3_dot(normal, estimate->normal) > 0.0f)
                near[count++] = estimate;
        }
    }
    return count > 0 && steps.interpolate_irradiance(near, count, position, normal, cache->accuracy, irradiance);
}
