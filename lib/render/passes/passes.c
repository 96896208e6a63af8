#include "render/passes/passes.h"
#include "base/array.h"
#include "base/parallel.h"
#include "render/maps.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define ACROSS  32     // points of the picture, in both directions
#define PHOTONS 100000 // looked at, at most: the more there are, the smaller the disk for k

// a becomes the mean over both.
static void join(Image *a, int m, const Image *b, int n)
{
    size_t pixels = (size_t)a->width * (size_t)a->height;
    OMP(omp parallel for schedule(static))
    for (size_t i = 0; i < pixels; i++)
        a->pixels[i] = steps.join_means(a->pixels[i], m, b->pixels[i], n);
}

void pass_sums_add(PassSums *sums, PassRun run)
{
    sums->runs[sums->count++] = run;
    while (sums->count > 1) {
        PassRun *a = &sums->runs[sums->count - 2];
        PassRun *b = &sums->runs[sums->count - 1];
        if (a->count != b->count || a->first % (2 * a->count) != 0)
            return;
        join(&a->mean, a->count, &b->mean, b->count);
        a->count += b->count;
        image_free(&b->mean);
        sums->count--;
    }
}

bool pass_sums_mean(const PassSums *sums, Image *mean, Error *error)
{
    const PassRun *last = &sums->runs[sums->count - 1];
    if (!image_create(mean, last->mean.width, last->mean.height, error))
        return false;
    memcpy(mean->pixels, last->mean.pixels, (size_t)mean->width * (size_t)mean->height * sizeof *mean->pixels);
    int count = last->count;
    for (int i = sums->count - 2; i >= 0; i--) { // the smaller ones first
        join(mean, count, &sums->runs[i].mean, sums->runs[i].count);
        count += sums->runs[i].count;
    }
    return true;
}

void pass_sums_free(PassSums *sums)
{
    while (sums->count > 0)
        image_free(&sums->runs[--sums->count].mean);
}

// Means are kept for as many runs as the number of passes has digits in base two, ten where nobody knows it; and a few more.
static bool has_room(const RenderOptions *options, const Passes *passes, Error *error)
{
    double pictures = 3.0;
    for (int left = passes->last - passes->first; left > 0 && pictures < 13.0; left /= 2)
        pictures++;
    double pixels = (double)options->settings.width * (double)options->settings.height;
    return array_has_room(pictures * pixels * (double)sizeof(Colour)) ||
           error_set(error, "not enough memory for the %.0f pictures of %d passes; use a smaller size", pictures,
                     passes->last - passes->first);
}

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

// A radius within which a typical point that the eye sees finds settings.k photons of one pass, m. 0: there are none.
static bool first_radius(const Scene *scene, const RenderOptions *options, float *radius, Error *error)
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

static bool begin(const Scene *scene, const RenderOptions *options, Passes *passes, Error *error)
{
    if (!has_room(options, passes, error))
        return false;
    if (passes->radius <= 0.0f)
        passes->radius = options->settings.radius;
    if (passes->radius <= 0.0f && options->integrator != INTEGRATOR_PATH &&
        !first_radius(scene, options, &passes->radius, error))
        return false;
    if (passes->radius <= 0.0f) // nobody will find a photon
        passes->radius = 0.01f * box_diagonal(bvh_bounds(scene->bvh));
    if (!passes->by_pixel || passes->points)
        return true;
    size_t pixels = (size_t)options->settings.width * (size_t)options->settings.height;
    passes->points = malloc(pixels * sizeof *passes->points);
    for (size_t i = 0; passes->points && i < pixels; i++)
        passes->points[i] = (PointStatistics){0.0f, passes->radius, {0.0f, 0.0f, 0.0f}};
    return passes->points || error_set(error, "not enough memory for the statistics of %zu pixels", pixels);
}

static bool run_pass(const Scene *scene, const RenderOptions *options, Passes *passes, float radius, RenderStats *stats,
                     Error *error)
{
    int number = passes->first + passes->done;
    RenderPass pass = {
        .radius = radius,
        .seed = options->seed,
        .first_sample = (uint32_t)number * (uint32_t)options->settings.samples,
        .points = passes->points,
        .alpha = passes->alpha,
    };
    RenderOptions own = *options;
    own.pass = &pass;
    own.seed = hash_u64(options->seed + hash_u64((uint64_t)number));
    PassRun run = {number, 1, {0, 0, NULL}};
    if (!render_image(scene, &own, &run.mean, stats, error))
        return false;
    stats->passes++;
    pass_sums_add(&passes->sums, run);
    passes->done++;
    return true;
}

bool passes_run(const Scene *scene, const RenderOptions *options, Passes *passes, RenderStats *stats, Error *error)
{
    *stats = (RenderStats){0};
    passes->samples = options->settings.samples;
    if (!begin(scene, options, passes, error))
        return false;
    float radius = passes->radius;
    int shrunk = 0;
    while (passes->first + passes->done < passes->last) {
        if (passes->by_pixel && passes->done >= INT_MAX / passes->samples)
            return error_set(error, "more than %d passes of %d eye rays a pixel cannot be counted", passes->done,
                             passes->samples);
        for (; !passes->by_pixel && shrunk < passes->first + passes->done; shrunk++) {
            radius = steps.next_radius(radius, shrunk + 1, passes->alpha);
            if (!(radius > 0.0f && radius < INFINITY))
                return error_set(error, "step 5.1 gives pass %d a radius of %g m", shrunk + 2, (double)radius);
        }
        if (!run_pass(scene, options, passes, radius, stats, error))
            return false;
        if (passes->heard && !passes->heard(passes->user, passes))
            break;
    }
    return true;
}

bool passes_picture(const Passes *passes, Image *image, Error *error)
{
    if (!pass_sums_mean(&passes->sums, image, error))
        return false;
    size_t pixels = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; passes->points && i < pixels; i++) // each eye ray has added its photons
        image->pixels[i] =
            colour_add(image->pixels[i], steps.point_radiance(passes->points[i], passes->done * passes->samples));
    return true;
}

void passes_free(Passes *passes)
{
    pass_sums_free(&passes->sums);
    free(passes->points);
    passes->points = NULL;
}
