// Indirect light along a line on the back wall of scenes/box_diffuse.yaml: looked up in the map at once, and by final
// gathering with N rays. Reference: many rays, over a map of ten times the photons.
//   4_line SCENE DATA NUMBERS
#include "photonlab.h"

#include <stdio.h>
#include <stdlib.h>

enum { POINTS = 121, K = 100, REFERENCE_RAYS = 8192, COUNTS = 4 };

static const int ray_counts[COUNTS] = {16, 64, 256, 1024};

// A map of this scene's photons, and room for an estimate from it.
typedef struct {
    PhotonMap *map;
    Gather gather;
} Lookup;

static void fail(const char *message)
{
    fprintf(stderr, "4_line: %s\n", message);
    exit(1);
}

static Lookup lookup_create(const Scene *scene, long photons, unsigned keep)
{
    Error error = {""};
    PhotonPass pass;
    PhotonPassOptions options = {.photons = photons, .depth = scene->settings.depth, .seed = 1, .keep = keep};
    if (!photon_pass_run(scene, &options, &pass, &error))
        fail(error.message);
    Lookup lookup = {.gather = {.k = K, .radius = INFINITY}};
    lookup.map = photon_map_build(pass.rest.photons, pass.rest.count, &error);
    lookup.gather.near = malloc(PHOTON_MAP_NEAREST_CAPACITY(K) * sizeof(NearPhoton));
    if (!lookup.map || !lookup.gather.near)
        fail(error.message);
    pass.rest = (PhotonArray){NULL, 0};
    photon_pass_free(&pass);
    return lookup;
}

// Final gathering on a matt surface: ρ/N Σ L, rays from the cosine hemisphere; L from the map where each ray lands.
static double gathered(const Scene *scene, Lookup *all, const Hit *at, int rays, Rng *rng)
{
    double sum = 0.0;
    for (int i = 0; i < rays; i++) {
        Ray ray = {at->position, steps.scatter_diffuse(at->normal, rng), at->primitive};
        Hit hit;
        if (!scene_intersect(scene, &ray, &hit) || !material_is_rough(hit.material))
            continue; // the open, or a lamp, whose light is counted as direct
        sum += (double)steps.estimate_radiance(all->map, &hit, vec3_negate(ray.direction), &all->gather).g;
    }
    return sum * (double)at->material->diffuse.g / rays;
}

int main(int count, char **arguments)
{
    Error error = {""};
    if (count != 4)
        fail("usage: 4_line SCENE DATA NUMBERS");
    if (!steps_load(NULL, &error))
        fail(error.message);
    Scene *scene = scene_load(arguments[1], &error);
    FILE *data = fopen(arguments[2], "w"), *numbers = fopen(arguments[3], "w");
    if (!scene || !data || !numbers)
        fail(scene ? "cannot write" : error.message);
    Lookup indirect = lookup_create(scene, scene->settings.photons, KEEP_INDIRECT);
    Lookup all = lookup_create(scene, scene->settings.photons, KEEP_ALL);
    Lookup fine = lookup_create(scene, 10 * scene->settings.photons, KEEP_ALL);

    double squares[COUNTS + 1] = {0.0};
    for (int i = 0; i < POINTS; i++) {
        Vec3 target = vec3(-0.9f + 1.8f * (float)i / (POINTS - 1), 0.2f, -1.0f), eye = scene->camera.position;
        Ray ray = {eye, vec3_normalize(vec3_sub(target, eye)), NO_PRIMITIVE};
        Hit hit;
        if (!scene_intersect(scene, &ray, &hit))
            fail("no wall there");
        Rng rng = rng_create(7, (uint64_t)i);
        double truth = gathered(scene, &fine, &hit, REFERENCE_RAYS, &rng);
        double found[COUNTS + 1];
        Vec3 wo = vec3_negate(ray.direction);
        found[0] = (double)steps.estimate_radiance(indirect.map, &hit, wo, &indirect.gather).g;
        for (int n = 0; n < COUNTS; n++)
            found[n + 1] = gathered(scene, &all, &hit, ray_counts[n], &rng);
        fprintf(data, "%.3f %.5f", (double)target.x, truth);
        for (int n = 0; n <= COUNTS; n++) {
            fprintf(data, " %.5f", found[n]);
            squares[n] += (found[n] / truth - 1.0) * (found[n] / truth - 1.0);
        }
        fprintf(data, "\n");
    }
    fprintf(numbers, "rms_percent_map %.2f\n", 100.0 * sqrt(squares[0] / POINTS));
    for (int n = 0; n < COUNTS; n++)
        fprintf(numbers, "rms_percent_%d %.2f\n", ray_counts[n], 100.0 * sqrt(squares[n + 1] / POINTS));
    scene_free(scene);
    return fclose(data) == 0 && fclose(numbers) == 0 ? 0 : 1;
}
