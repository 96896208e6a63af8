#include "render/render.h"
#include "base/array.h"
#include "base/parallel.h"
#include "render/eye.h"
#include "render/final_gather.h"
#include "render/maps.h"

#include <stdlib.h>
#include <string.h>

#define TILE 16 // pixels a side; a thread's share of work, and how far estimates are shared

static void render_pixel(Eye *eye, Image *image, int column, int row)
{
    const RenderSettings *settings = &eye->options->settings;
    const RenderPass *pass = eye->options->pass;
    uint64_t pixel = (uint64_t)row * (uint64_t)settings->width + (uint64_t)column;
    float aspect = (float)settings->width / (float)settings->height;
    Colour sum = colour_grey(0.0f);
    eye->point = pass && pass->points ? &pass->points[pixel] : NULL;
    memset(eye->memory, 0, sizeof eye->memory);
    eye->remembered = 0;
    eye->sampler.pixel = hash_u64((pass ? pass->seed : eye->options->seed) ^ hash_u64(pixel));
    for (int s = 0; s < settings->samples; s++) {
        eye->sampler.index = (pass ? pass->first_sample : 0) + (uint32_t)s;
        eye->rng = rng_create(~eye->options->seed, pixel * (uint64_t)settings->samples + (uint64_t)s);
        float u, v;
        sampler_point(&eye->sampler, SAMPLER_FILM, &u, &v);
        float x = ((float)column + u) / (float)settings->width;
        float y = ((float)row + v) / (float)settings->height;
        Ray ray = camera_ray(&eye->scene->camera, x, y, aspect);
        if (eye->point) {
            eye->gather.radius = eye->point->radius;
            eye->found = 0;
            eye->flux = colour_grey(0.0f);
        }
        Colour radiance =
            eye->options->integrator == INTEGRATOR_PATH ? path_radiance(eye, ray) : eye_radiance(eye, &ray);
        if (eye->point)
            *eye->point = steps.add_photons(*eye->point, eye->found, eye->flux, pass->alpha);
        sum = colour_add(sum, radiance);
    }
    *image_at(image, column, row) = colour_scale(sum, 1.0f / (float)settings->samples);
}

static void render_tile(Eye *eye, Image *image, int left, int top, int width, int height)
{
    radiance_cache_clear(&eye->caustic_cache);
    radiance_cache_clear(&eye->rest_cache);
    if (eye->own_cache)
        irradiance_cache_clear(eye->own_cache);
    for (int row = top; row < top + height; row++)
        for (int column = left; column < left + width; column++)
            render_pixel(eye, image, column, row);
}

// Of one map: that many may lie within a pass's radius. Memory is only used as far as it is written to.
static size_t most_photons(const Maps *maps)
{
    size_t caustic = maps->caustic ? photon_map_count(maps->caustic) : 0;
    size_t rest = maps->rest ? photon_map_count(maps->rest) : 0;
    return caustic > rest ? caustic : rest;
}

// Fills in a zeroed eye. False: no memory.
static bool eye_open(Eye *eye, const Scene *scene, const RenderOptions *options, const Maps *maps, FinalGather *final)
{
    size_t k = (size_t)options->settings.k;
    float radius = options->settings.radius > 0.0f ? options->settings.radius : INFINITY;
    if (options->pass) {
        k = most_photons(maps);
        radius = options->pass->radius;
    }
    NearPhoton *near = malloc(PHOTON_MAP_NEAREST_CAPACITY(k) * sizeof *near);
    eye->scene = scene;
    eye->options = options;
    eye->caustic = maps->caustic;
    eye->rest = maps->rest;
    eye->gather = (Gather){.k = k, .radius = radius, .glossy = options->play.glossy, .near = near};
    eye->final = final;
    eye->own_cache = final ? irradiance_cache_create(GATHER_ACCURACY, final->size) : NULL;
    return near && (!final || eye->own_cache);
}

static void give_estimates(const RenderOptions *options, const IrradianceCache *cache, RenderStats *stats)
{
    size_t count;
    const IrradianceEstimate *estimates = irradiance_cache_estimates(cache, &count);
    stats->estimates += count;
    for (size_t i = 0; options->estimates.take && i < count; i++)
        options->estimates.take(options->estimates.user, &estimates[i]);
}

static void eye_pass(Eye *eyes, int threads, Image *image)
{
    const RenderOptions *options = eyes[0].options;
    int across = (image->width + TILE - 1) / TILE, tiles = across * ((image->height + TILE - 1) / TILE);
    int done = 0;
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (int tile = 0; tile < tiles; tile++) {
        int left = tile % across * TILE, top = tile / across * TILE;
        int width = left + TILE < image->width ? TILE : image->width - left;
        int height = top + TILE < image->height ? TILE : image->height - top;
        render_tile(&eyes[parallel_index()], image, left, top, width, height);
#pragma omp critical(render_progress)
        {
            if (options->tiles.take)
                options->tiles.take(options->tiles.user, image, left, top, width, height);
            progress_report(&options->progress, "eye rays", (double)++done / (double)tiles);
        }
    }
}

// Told before anything is traced: what takes memory, and how much depends on no photon.
static bool has_room(const RenderOptions *options, Error *error)
{
    size_t k = options->pass ? 0 : (size_t)options->settings.k;
    double near = (double)PHOTON_MAP_NEAREST_CAPACITY(k) * (double)sizeof(NearPhoton);
    return array_has_room(near * parallel_threads(options->threads)) ||
           error_set(error, "not enough memory for %d photons in an estimate; use a smaller k", options->settings.k);
}

// One eye a thread for all that follows.
static bool look(const Scene *scene, const RenderOptions *options, const Maps *maps, Image *image, RenderStats *stats)
{
    int threads = parallel_threads(options->threads);
    bool gathers = options->integrator == INTEGRATOR_GATHER;
    float size = box_diagonal(bvh_bounds(scene->bvh));
    FinalGather final = {maps->ends, NULL, size, 2.0f * scene->camera.tan_half_fov / (float)image->height};
    final.cache = gathers ? irradiance_cache_create(GATHER_ACCURACY, size) : NULL;
    Eye *eyes = calloc((size_t)threads, sizeof *eyes);
    bool ok = eyes && (final.cache || !gathers);
    for (int i = 0; ok && i < threads; i++)
        ok = eye_open(&eyes[i], scene, options, maps, gathers ? &final : NULL);
    if (ok && gathers) {
        double start = clock_seconds();
        ok = final_gather_fill(eyes, threads);
        stats->gather_seconds += clock_seconds() - start;
        if (ok)
            give_estimates(options, final.cache, stats);
    }
    if (ok)
        eye_pass(eyes, threads, image);
    for (int i = 0; eyes && i < threads; i++) {
        stats->eye_rays += eyes[i].rays;
        free(eyes[i].gather.near);
        irradiance_cache_free(eyes[i].own_cache);
    }
    free(eyes);
    irradiance_cache_free(final.cache);
    return ok;
}

bool render_image(const Scene *scene, const RenderOptions *options, Image *image, RenderStats *stats, Error *error)
{
    Maps maps = {NULL, NULL, NULL};
    if (!options->pass)
        *stats = (RenderStats){0};
    if (!image_create(image, options->settings.width, options->settings.height, error))
        return false;
    bool ok = has_room(options, error) &&
              (options->integrator == INTEGRATOR_PATH || maps_make(scene, options, &maps, stats, error));
    if (ok) {
        double start = clock_seconds();
        ok = look(scene, options, &maps, image, stats) ||
             error_set(error, "not enough memory for %d photons in an estimate; use a smaller k", options->settings.k);
        stats->eye_seconds += clock_seconds() - start;
    }
    maps_free(&maps);
    if (!ok)
        image_free(image);
    return ok;
}
