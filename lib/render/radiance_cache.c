#include "render/radiance_cache.h"

#define SAME_WAY  0.98f // cosine between normals that still count as one surface
#define OFF_PLANE 0.1f  // part of the reach by which a point may lie above or below

bool radiance_cache_find(const RadianceCache *cache, Vec3 position, Vec3 normal, const void *material, Colour *radiance)
{
    Colour sum = colour_grey(0.0f);
    float weights = 0.0f;
    for (size_t i = 0; i < cache->count; i++) {
        const CachedRadiance *entry = &cache->entries[i];
        Vec3 offset = vec3_sub(position, entry->position);
        float distance2 = vec3_dot(offset, offset);
        if (entry->material != material || distance2 >= entry->reach * entry->reach ||
            vec3_dot(normal, entry->normal) < SAME_WAY || fabsf(vec3_dot(offset, normal)) > OFF_PLANE * entry->reach)
            continue;
        float weight = 1.0f - sqrtf(distance2) / entry->reach;
        sum = colour_add(sum, colour_scale(entry->radiance, weight));
        weights += weight;
    }
    if (weights <= 0.0f)
        return false;
    *radiance = colour_scale(sum, 1.0f / weights);
    return true;
}

void radiance_cache_add(RadianceCache *cache, const CachedRadiance *entry)
{
    if (cache->count < RADIANCE_CACHE_CAPACITY)
        cache->entries[cache->count++] = *entry;
}
