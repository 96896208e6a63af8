#include "render/render.h"
#include "base/parallel.h"
#include "render/eye.h"

#include <stdlib.h>

#define TILE 16 // pixels a side; a thread's share of work, and how far estimates are shared

typedef struct {
    PhotonMap *caustic, *rest;
} Maps;

static void render_pixel(Eye *eye, Image *image, int column, int row)
{
    const RenderSettings *settings = &eye->options->settings;
    uint64_t pixel = (uint64_t)row * (uint64_t)settings->width + (uint64_t)column;
    float aspect = (float)settings->width / (float)settings->height;
    Colour sum = colour_grey(0.0f);
    eye->sampler.pixel = hash_u64(eye->options->seed ^ hash_u64(pixel));
    for (int s = 0; s < settings->samples; s++) {
        eye->sampler.index = (uint32_t)s;
        eye->rng = rng_create(~eye->options->seed, pixel * (uint64_t)settings->samples + (uint64_t)s);
        float u, v;
        sampler_point(&eye->sampler, SAMPLER_FILM, &u, &v);
        float x = ((float)column + u) / (float)settings->width;
        float y = ((float)row + v) / (float)settings->height;
        Ray ray = camera_ray(&eye->scene->camera, x, y, aspect);
        Colour radiance =
            eye->options->integrator == INTEGRATOR_PATH ? path_radiance(eye, ray) : eye_radiance(eye, &ray);
        sum = colour_add(sum, radiance);
    }
    *image_at(image, column, row) = colour_scale(sum, 1.0f / (float)settings->samples);
}

static void render_tile(Eye *eye, Image *image, int tile)
{
    int tiles_across = (image->width + TILE - 1) / TILE;
    int left = tile % tiles_across * TILE;
    int top = tile / tiles_across * TILE;
    radiance_cache_clear(&eye->caustic_cache);
    radiance_cache_clear(&eye->rest_cache);
    for (int row = top; row < top + TILE && row < image->height; row++)
        for (int column = left; column < left + TILE && column < image->width; column++)
            render_pixel(eye, image, column, row);
}

static Eye *eye_create(const Scene *scene, const RenderOptions *options, const Maps *maps)
{
    Eye *eye = calloc(1, sizeof *eye);
    if (!eye)
        return NULL;
    size_t k = (size_t)options->settings.k;
    float radius = options->settings.radius > 0.0f ? options->settings.radius : INFINITY;
    NearPhoton *near = malloc(PHOTON_MAP_NEAREST_CAPACITY(k) * sizeof *near);
    eye->scene = scene;
    eye->options = options;
    eye->caustic = maps->caustic;
    eye->rest = maps->rest;
    eye->gather = (Gather){.k = k, .radius = radius, .glossy = options->play.glossy, .near = near};
    if (near)
        return eye;
    free(eye);
    return NULL;
}

static void eye_free(Eye *eye)
{
    if (eye)
        free(eye->gather.near);
    free(eye);
}

static bool eye_pass(const Scene *scene, const RenderOptions *options, const Maps *maps, Image *image,
                     RenderStats *stats)
{
    int tiles = ((image->width + TILE - 1) / TILE) * ((image->height + TILE - 1) / TILE);
    int done = 0;
    bool ok = true;
    uint64_t rays = 0;
#pragma omp parallel num_threads(parallel_threads(options->threads)) reduction(+ : rays) reduction(&& : ok)
    {
        Eye *eye = eye_create(scene, options, maps);
        ok = eye != NULL;
#pragma omp for schedule(dynamic)
        for (int tile = 0; tile < tiles; tile++) {
            if (eye)
                render_tile(eye, image, tile);
#pragma omp critical(render_progress)
            progress_report(&options->progress, "eye rays", (double)++done / (double)tiles);
        }
        rays += eye ? eye->rays : 0;
        eye_free(eye);
    }
    stats->eye_rays = rays;
    return ok;
}

static PhotonMap *build_map(PhotonArray *photons, Error *error)
{
    PhotonMap *map = photon_map_build(photons->photons, photons->count, error);
    *photons = (PhotonArray){NULL, 0}; // the map has taken them over
    return map;
}

static bool make_maps(const Scene *scene, const RenderOptions *options, Maps *maps, RenderStats *stats, Error *error)
{
    bool all = options->integrator == INTEGRATOR_PHOTONS_ONLY;
    PhotonPassOptions pass_options = {
        .photons = options->settings.photons,
        .depth = options->settings.depth,
        .seed = options->seed,
        .threads = options->threads,
        .keep = all ? KEEP_ALL : KEEP_CAUSTIC | KEEP_INDIRECT,
        .play = options->play,
        .progress = options->progress,
    };
    PhotonPass pass;
    steps_play(options->play);
    if (!photon_pass_run(scene, &pass_options, &pass, error))
        return false;
    stats->photons_emitted = pass.emitted;
    stats->photons_stored = pass.stored;
    stats->photon_rays = pass.segments;
    stats->unsound = pass.unsound;
    stats->photon_seconds = pass.seconds;
    stats->ledger = pass.ledger;
    double start = clock_seconds();
    maps->caustic = build_map(&pass.caustic, error);
    maps->rest = maps->caustic ? build_map(&pass.rest, error) : NULL;
    stats->build_seconds = clock_seconds() - start;
    photon_pass_free(&pass);
    if (!maps->rest)
        return false;
    stats->map_bytes = photon_map_bytes(maps->caustic) + photon_map_bytes(maps->rest);
    return true;
}

bool render_image(const Scene *scene, const RenderOptions *options, Image *image, RenderStats *stats, Error *error)
{
    Maps maps = {NULL, NULL};
    *stats = (RenderStats){0};
    if (!image_create(image, options->settings.width, options->settings.height, error))
        return false;
    bool ok = options->integrator == INTEGRATOR_PATH || make_maps(scene, options, &maps, stats, error);
    if (ok) {
        double start = clock_seconds();
        ok = eye_pass(scene, options, &maps, image, stats) ||
             error_set(error, "not enough memory for %d photons in an estimate; use a smaller k", options->settings.k);
        stats->eye_seconds = clock_seconds() - start;
    }
    photon_map_free(maps.caustic);
    photon_map_free(maps.rest);
    if (!ok)
        image_free(image);
    return ok;
}
