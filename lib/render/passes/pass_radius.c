#include "render/maps.h"
#include "render/passes/passes.h"

#include <stdlib.h>

#define ACROSS  32     // points of the picture, in both directions
#define PHOTONS 100000 // looked at, at most: the more there are, the smaller the disk for k

static int compare(const void *a, const void *b)
{
    float x = *(const float *)a;
    float y = *(const float *)b;
    return (x > y) - (x < y);
}

// Distances² to the k-th photon at what eye rays meet first, where that is rough; how many.
static size_t distances(const Scene *scene, const RenderSettings *settings, const PhotonMap *map, size_t k,
                        NearPhoton *near, float *distance2)
{
    size_t count = 0;
    float aspect = (float)settings->width / (float)settings->height;
    for (int i = 0; i < ACROSS * ACROSS; i++) {
        Ray ray = camera_ray(&scene->camera, ((float)(i % ACROSS) + 0.5f) / ACROSS,
                             ((float)(i / ACROSS) + 0.5f) / ACROSS, aspect);
        Hit hit;
        float found2 = INFINITY;
        if (scene_intersect(scene, &ray, &hit) && material_is_rough(hit.material) &&
            photon_map_nearest(map, hit.position, k, &found2, near) == k)
            distance2[count++] = found2;
    }
    return count;
}

// The median disk holds k photons of `looked_at`; a pass has `photons`.
static bool median_radius(const Scene *scene, const RenderOptions *options, const PhotonMap *map, long looked_at,
                          float *radius, Error *error)
{
    size_t k = (size_t)options->settings.k;
    NearPhoton *near = malloc(PHOTON_MAP_NEAREST_CAPACITY(k) * sizeof *near);
    float distance2[ACROSS * ACROSS];
    if (!near)
        return error_set(error, "not enough memory for %zu photons in an estimate; use a smaller k", k);
    size_t count = distances(scene, &options->settings, map, k, near, distance2);
    free(near);
    qsort(distance2, count, sizeof *distance2, compare);
    *radius = count ? sqrtf(distance2[count / 2] * (float)looked_at / (float)options->settings.photons) : 0.0f;
    return true;
}

bool pass_first_radius(const Scene *scene, const RenderOptions *options, float *radius, Error *error)
{
    RenderOptions few = *options;
    few.integrator = INTEGRATOR_PHOTONS;
    few.settings.photons = options->settings.photons < PHOTONS ? options->settings.photons : PHOTONS;
    Maps maps = {NULL, NULL, NULL};
    RenderStats stats = {0};
    bool ok = maps_make(scene, &few, &maps, &stats, error);
    if (ok) {
        bool is_indirect = photon_map_count(maps.rest) >= photon_map_count(maps.caustic);
        ok = median_radius(scene, options, is_indirect ? maps.rest : maps.caustic, few.settings.photons, radius, error);
    }
    maps_free(&maps);
    return ok;
}
