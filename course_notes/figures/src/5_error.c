// The error of the mean over passes: 5_error SCENE REFERENCE SIZE PHOTONS K PASSES DATA NUMBERS
// With the radius of step 5.1, with one for each pixel, and with one that stays. DATA: passes, then for each of these the error
// against the reference (which may be finer) and the one that the picture itself tells, by half of its passes; 0: it has no half.
// Error: the mean of (x−r)²/(r²+0.01) without the worst 0.1 % of pixels and without the lamp of scenes/box_*.yaml.
#include "photonlab.h"

#include <stdio.h>
#include <stdlib.h>

enum { WAYS = 3 };

static const struct {
    const char *name;
    float alpha;
    bool by_pixel;
} ways[WAYS] = {{"pass", PASS_ALPHA, false}, {"pixel", PASS_ALPHA, true}, {"fixed", 1.0f, false}};

typedef struct {
    int passes;
    double error[WAYS], told[WAYS];
} Mark;

// What is looked at after each pass.
typedef struct {
    Image truth, half;
    int way, count;
    Mark marks[64];
} Watch;

static void fail(const char *message)
{
    fprintf(stderr, "5_error: %s\n", message);
    exit(1);
}

static double error_of(const Image *image, const Image *reference)
{
    ImageDifference difference;
    Error error = {""};
    int w = image->width, h = image->height;
    ImageMask lamp = {w * 204 / 512, h * 56 / 512, (w * 308 + 511) / 512, (h * 90 + 511) / 512};
    if (!image_difference(image, reference, lamp, &difference, &error))
        fail(error.message);
    return difference.relative_mse_trimmed;
}

// After 1, 2, 4, 8 … passes.
static bool look(void *user, const Passes *passes)
{
    Watch *watch = user;
    if ((passes->done & (passes->done - 1)) != 0)
        return true;
    Error error = {""};
    Image image;
    if (!passes_picture(passes, &image, &error))
        fail(error.message);
    Mark *mark = &watch->marks[watch->count++];
    mark->passes = passes->done;
    mark->error[watch->way] = error_of(&image, &watch->truth);
    if (passes->done > 1) {
        mark->told[watch->way] = error_of(&watch->half, &image);
        image_free(&watch->half);
    }
    watch->half = image;
    return true;
}

static void run(const Scene *scene, const RenderOptions *options, Watch *watch, int last, FILE *numbers)
{
    Error error = {""};
    RenderStats stats;
    Passes passes = {.alpha = ways[watch->way].alpha,
                     .by_pixel = ways[watch->way].by_pixel,
                     .last = last,
                     .heard = look,
                     .user = watch};
    watch->count = 0;
    if (!passes_run(scene, options, &passes, &stats, &error))
        fail(error.message);
    if (watch->way == 0)
        fprintf(numbers, "radius_cm %.2f\nmap_kB %.0f\nmap_all_MB %.0f\nphotons_million %.1f\n",
                100.0 * (double)passes.radius, (double)stats.map_bytes / 1e3, (double)stats.map_bytes * last / 1e6,
                (double)stats.photons_emitted / 1e6);
    image_free(&watch->half);
    passes_free(&passes);
}

int main(int count, char **arguments)
{
    Error error = {""};
    Image reference;
    if (count != 9)
        fail("usage: 5_error SCENE REFERENCE SIZE PHOTONS K PASSES DATA NUMBERS");
    Scene *scene = steps_load(NULL, &error) ? scene_load(arguments[1], &error) : NULL;
    FILE *data = fopen(arguments[7], "w"), *numbers = fopen(arguments[8], "w");
    if (!scene || !image_read(&reference, arguments[2], &error) || !data || !numbers)
        fail(error.message[0] ? error.message : "cannot write");
    RenderOptions options = {
        .integrator = INTEGRATOR_PHOTONS, .settings = scene->settings, .seed = 1, .glass_sides = 2};
    options.settings.width = options.settings.height = atoi(arguments[3]);
    options.settings.photons = atol(arguments[4]);
    options.settings.k = atoi(arguments[5]);
    options.settings.samples = 1;
    static Watch watch;
    if (!image_blocks(&reference, reference.width / options.settings.width, (ImageMask){0, 0, 0, 0}, &watch.truth,
                      &error))
        fail(error.message);
    for (watch.way = 0; watch.way < WAYS; watch.way++)
        run(scene, &options, &watch, atoi(arguments[6]), numbers);
    for (int m = 0; m < watch.count; m++) {
        fprintf(data, "%d", watch.marks[m].passes);
        for (int a = 0; a < WAYS; a++)
            fprintf(data, " %.4g %.4g", watch.marks[m].error[a], watch.marks[m].told[a]);
        fprintf(data, "\n");
    }
    const Mark *end = &watch.marks[watch.count - 1], *first = &watch.marks[0];
    for (int a = 0; a < WAYS; a++) {
        double fall = log(end->error[a] / first->error[a]) / log((double)end->passes);
        fprintf(numbers, "first_%s %.2g\nlast_%s %.2g\ntold_%s %.2g\nslope_%s %.2f\n", ways[a].name, first->error[a],
                ways[a].name, end->error[a], ways[a].name, end->told[a], ways[a].name, fall);
    }
    scene_free(scene);
    return fclose(data) == 0 && fclose(numbers) == 0 ? 0 : 1;
}
