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

typedef struct {
    int width, height;
    int (*points)[2]; // pixels that come next
    size_t count;
    bool *open; // of each: no estimate serves there
} Grid;

// Those on a grid of this spacing which were on none before.
static void grid_points(Grid *grid, int spacing)
{
    grid->count = 0;
    for (int y = 0; y < grid->height; y += spacing)
        for (int x = 0; x < grid->width; x += spacing)
            if (spacing == COARSEST || x % (2 * spacing) || y % (2 * spacing)) {
                grid->points[grid->count][0] = x;
                grid->points[grid->count++][1] = y;
            }
}

// What the eye sees through a pixel's middle; true: a rough surface where no estimate serves.
static bool is_open(Eye *eye, const Grid *grid, const int point[2], Hit *hit, Vec3 *wo, float *distance)
{
    uint64_t pixel = (uint64_t)point[1] * (uint64_t)grid->width + (uint64_t)point[0];
    eye->rng = rng_create(hash_u64(eye->options->seed) + 1, pixel);
    eye->sampler = (Sampler){hash_u64(eye->rng.state), 0};
    float x = ((float)point[0] + 0.5f) / (float)grid->width;
    float y = ((float)point[1] + 0.5f) / (float)grid->height;
    Ray ray = camera_ray(&eye->scene->camera, x, y, (float)grid->width / (float)grid->height);
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

// Leaves those points that are open, in an order in which neighbours are far apart.
static void keep_open(Eye *const eyes[], int threads, Grid *grid, int (*kept)[2])
{
    if (grid->count == 0)
        return;
#pragma omp parallel for schedule(dynamic, 256) num_threads(threads)
    for (size_t i = 0; i < grid->count; i++) {
        Hit hit;
        Vec3 wo;
        float distance;
        grid->open[i] = is_open(eyes[parallel_index()], grid, grid->points[i], &hit, &wo, &distance);
    }
    size_t stride = stride_through(grid->count);
    size_t count = 0;
    for (size_t i = 0; i < grid->count; i++) {
        size_t at = i * stride % grid->count;
        if (!grid->open[at])
            continue;
        kept[count][0] = grid->points[at][0];
        kept[count++][1] = grid->points[at][1];
    }
    grid->count = count;
}

// Whole batches, whatever the number of threads: which estimates an estimate knows of does not hang on luck.
static bool fill_batch(Eye *const eyes[], int threads, const Grid *grid, int (*points)[2], size_t count)
{
    IrradianceEstimate made[BATCH];
    bool is_made[BATCH];
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
    for (size_t i = 0; i < count; i++) {
        Eye *eye = eyes[parallel_index()];
        Hit hit;
        Vec3 wo;
        float distance;
        is_made[i] = is_open(eye, grid, points[i], &hit, &wo, &distance) &&
                     (irradiance_estimate_make(eye, &hit, wo, distance, &made[i]), true);
    }
    bool ok = true;
    for (size_t i = 0; i < count; i++)
        ok = (!is_made[i] || irradiance_cache_add(eyes[0]->final->cache, &made[i])) && ok;
    return ok;
}

bool final_gather_fill(Eye *const eyes[], int threads, int width, int height)
{
    size_t pixels = (size_t)width * (size_t)height;
    Grid grid = {width, height, malloc(pixels * sizeof *grid.points), 0, malloc(pixels * sizeof *grid.open)};
    int(*kept)[2] = malloc(pixels * sizeof *kept);
    bool ok = grid.points && grid.open && kept;
    for (int level = 0; ok && level < LEVELS; level++) {
        grid_points(&grid, COARSEST >> level);
        keep_open(eyes, threads, &grid, kept);
        for (size_t first = 0; first < grid.count; first += BATCH) {
            ok = fill_batch(eyes, threads, &grid, kept + first,
                            grid.count - first < BATCH ? grid.count - first : BATCH) &&
                 ok;
            progress_report(&eyes[0]->options->progress, "gather rays",
                            (level + (double)first / (double)grid.count) / LEVELS);
        }
    }
    free(grid.points);
    free(grid.open);
    free(kept);
    return ok;
}
