// Which points get an estimate, and when: before the picture is made, on ever finer grids of pixels.
#include "render/final_gather.h"

#include "base/parallel.h"

#include <stdlib.h>

#define MOST_SURFACES 16 // mirrors and glass in front of a rough surface

// The rough surface that the ray through a pixel's middle ends on, and how far away.
static bool first_rough(Eye *eye, Ray ray, Hit *hit, Vec3 *wo, float *distance)
{
    *distance = 0.0f;
    for (int bounce = 0; bounce < MOST_SURFACES; bounce++) {
        if (!scene_intersect(eye->scene, &ray, hit))
            return false;
        *distance += hit->distance;
        Vec3 refracted = ray.direction;
        *wo = vec3_negate(ray.direction);
        if (material_is_rough(hit->material))
            return true;
        if (hit->material->type == MATERIAL_LIGHT)
            return false;
        if (hit->material->type == MATERIAL_GLASS &&
            rng_float(&eye->rng) >= glass_optics(hit, ray.direction, hit->material->index[1], &refracted))
            ray.direction = refracted;
        else
            ray.direction = mirror_direction(ray.direction, hit->normal);
        ray.origin = hit->position;
        ray.from = hit->primitive;
    }
    return false;
}

// Where the last rays of this pixel ended, another ends next to them: no need to ask the cache again.
static bool find_remembered(const Eye *eye, const Hit *hit, float near, Colour *irradiance)
{
    for (int i = 0; i < EYE_MEMORY; i++) {
        Vec3 offset = vec3_sub(hit->position, eye->memory[i].position);
        if (vec3_dot(offset, offset) < near * near && vec3_dot(hit->normal, eye->memory[i].normal) > 0.999f) {
            *irradiance = eye->memory[i].irradiance;
            return true;
        }
    }
    return false;
}

Colour final_gather_irradiance(Eye *eye, const Hit *hit, Vec3 wo, float distance)
{
    Colour irradiance;
    if (find_remembered(eye, hit, distance * eye->final->pixel, &irradiance))
        return irradiance;
    if (!irradiance_cache_find(eye->final->cache, hit->position, hit->normal, &irradiance) &&
        !irradiance_cache_find(eye->own_cache, hit->position, hit->normal, &irradiance)) {
        // No pixel's middle saw this place. Its estimate stays within the tile, so that threads do not matter.
        Rng rng = eye->rng;
        Sampler sampler = eye->sampler;
        IrradianceEstimate estimate;
        irradiance_estimate_make(eye, hit, wo, distance, &estimate);
        irradiance_cache_add(eye->own_cache, &estimate);
        irradiance = estimate.irradiance;
        eye->rng = rng;
        eye->sampler = sampler;
    }
    eye->memory[eye->remembered++ % EYE_MEMORY] = (Remembered){hit->position, hit->normal, irradiance};
    return irradiance;
}

#define LEVELS   6
#define COARSEST (1 << (LEVELS - 1)) // pixels between the first estimates
#define BATCH    128                 // estimates made at a time, blind to each other

#define CLOSED UINT32_MAX // in place of a pixel: nothing to do there

// Those on a grid of this spacing which were on none before; how many.
static size_t grid_pixels(const RenderSettings *settings, int spacing, uint32_t *pixels)
{
    size_t count = 0;
    for (int y = 0; y < settings->height; y += spacing)
        for (int x = 0; x < settings->width; x += spacing)
            if (spacing == COARSEST || x % (2 * spacing) || y % (2 * spacing))
                pixels[count++] = (uint32_t)(y * settings->width + x);
    return count;
}

// What the eye sees through a pixel's middle; true: a rough surface where no estimate serves.
static bool is_open(Eye *eye, uint32_t pixel, Hit *hit, Vec3 *wo, float *distance)
{
    int width = eye->options->settings.width, height = eye->options->settings.height;
    eye->rng = rng_create(hash_u64(eye->options->seed) + 1, pixel);
    eye->sampler = (Sampler){hash_u64(eye->rng.state), 0};
    float x = ((float)(pixel % (uint32_t)width) + 0.5f) / (float)width;
    float y = ((float)(pixel / (uint32_t)width) + 0.5f) / (float)height;
    Ray ray = camera_ray(&eye->scene->camera, x, y, (float)width / (float)height);
    Colour known;
    return first_rough(eye, ray, hit, wo, distance) &&
           !irradiance_cache_find(eye->final->cache, hit->position, hit->normal, &known);
}

static size_t greatest_common_divisor(size_t a, size_t b)
{
    return b ? greatest_common_divisor(b, a % b) : a;
}

// Steps of this size through `count` places, round and round, meet each once, and neighbours late after each other.
static size_t stride_through(size_t count)
{
    size_t stride = (size_t)(0.618 * (double)count) + 1;
    while (greatest_common_divisor(stride, count) != 1)
        stride++;
    return stride;
}

// Those of the pixels that are open, in an order in which neighbours are far apart; how many. The others become CLOSED.
static size_t keep_open(Eye *eyes, int threads, uint32_t *pixels, size_t count, uint32_t *kept)
{
#pragma omp parallel for schedule(dynamic, 256) num_threads(threads)
    for (size_t i = 0; i < count; i++) {
        Hit hit;
        Vec3 wo;
        float distance;
        if (!is_open(&eyes[parallel_index()], pixels[i], &hit, &wo, &distance))
            pixels[i] = CLOSED;
    }
    size_t stride = stride_through(count), open = 0;
    for (size_t i = 0; i < count; i++)
        if (pixels[i * stride % count] != CLOSED)
            kept[open++] = pixels[i * stride % count];
    return open;
}

// Whole batches, whatever the number of threads: which estimates an estimate knows of does not hang on luck.
static bool fill_batch(Eye *eyes, int threads, const uint32_t *pixels, size_t count)
{
    IrradianceEstimate made[BATCH];
    bool is_made[BATCH], ok = true;
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
    for (size_t i = 0; i < count; i++) {
        Eye *eye = &eyes[parallel_index()];
        Hit hit;
        Vec3 wo;
        float distance;
        is_made[i] = is_open(eye, pixels[i], &hit, &wo, &distance);
        if (is_made[i])
            irradiance_estimate_make(eye, &hit, wo, distance, &made[i]);
    }
    for (size_t i = 0; i < count; i++)
        ok = (!is_made[i] || irradiance_cache_add(eyes[0].final->cache, &made[i])) && ok;
    return ok;
}

bool final_gather_fill(Eye *eyes, int threads)
{
    const RenderSettings *settings = &eyes[0].options->settings;
    size_t all = (size_t)settings->width * (size_t)settings->height;
    uint32_t *pixels = malloc(all * sizeof *pixels), *open = malloc(all * sizeof *open);
    bool ok = pixels && open;
    for (int level = 0; ok && level < LEVELS; level++) {
        size_t count = grid_pixels(settings, COARSEST >> level, pixels);
        count = keep_open(eyes, threads, pixels, count, open);
        for (size_t first = 0; first < count; first += BATCH) {
            ok = fill_batch(eyes, threads, open + first, count - first < BATCH ? count - first : BATCH) && ok;
            progress_report(&eyes[0].options->progress, "gather rays",
                            (level + (double)first / (double)count) / LEVELS);
        }
    }
    free(pixels);
    free(open);
    return ok;
}
