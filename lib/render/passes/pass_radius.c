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

// Among the disks with k photons of `looked_at`, around what eye rays meet first where that is rough, the median one; a pass has
// more photons, and so a smaller disk.
static bool median_radius(const Scene *scene, const RenderSettings *settings, const PhotonMap *map, long looked_at,
                          float *radius, Error *error)
{
    size_t k = (size_t)settings->k, count = 0;
    NearPhoton *near = malloc(PHOTON_MAP_NEAREST_CAPACITY(k) * sizeof *near);
    float distance2[ACROSS * ACROSS], aspect = (float)settings->width / (float)settings->height;
    if (!near)
        return error_set(error, "not enough memory for %zu photons in an estimate; use a smaller k", k);
    for (int i = 0; i < ACROSS * ACROSS; i++) {
        Ray ray = camera_ray(&scene->camera, ((float)(i % ACROSS) + 0.5f) / ACROSS,
                             ((float)(i / ACROSS) + 0.5f) / ACROSS, aspect);
        Hit hit;
        distance2[count] = INFINITY;
        count += scene_intersect(scene, &ray, &hit) && material_is_rough(hit.material) &&
                 photon_map_nearest(map, hit.position, k, &distance2[count], near) == k;
    }
    free(near);
    qsort(distance2, count, sizeof *distance2, compare);
    *radius = count ? sqrtf(distance2[count / 2] * (float)looked_at / (float)settings->photons) : 0.0f;
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
        const PhotonMap *larger =
            photon_map_count(maps.rest) >= photon_map_count(maps.caustic) ? maps.rest : maps.caustic;
        ok = median_radius(scene, &options->settings, larger, few.settings.photons, radius, error);
    }
    maps_free(&maps);
    return ok;
}
