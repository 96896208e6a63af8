// Pictures by a radius for each pixel: 5_radii SCENE SIZE PHOTONS PASSES PICTURE RADII NUMBERS
// RADII: how far each has shrunk. White: not at all; black: to a third or less. NUMBERS: the median over pixels that have
// found something, and what step 5.1 says, in cm.
#include "photonlab.h"

#include <stdio.h>
#include <stdlib.h>

static void fail(const char *message)
{
    fprintf(stderr, "5_radii: %s\n", message);
    exit(1);
}

static int compare(const void *a, const void *b)
{
    const float *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

// As a grey picture; the median of those that have shrunk.
static float draw(const Passes *passes, Image *image)
{
    int pixels = image->width * image->height, shrunk = 0;
    float *radii = malloc((size_t)pixels * sizeof *radii);
    if (!radii)
        fail("not enough memory");
    for (int p = 0; p < pixels; p++) {
        float share = passes->points[p].radius / passes->radius;
        float grey = fmaxf(0.0f, 1.0f + logf(share) / logf(3.0f));
        image->pixels[p] = colour_grey(powf(grey, 2.2f)); // evenly on a screen
        if (share < 1.0f)
            radii[shrunk++] = passes->points[p].radius;
    }
    qsort(radii, (size_t)shrunk, sizeof *radii, compare);
    float median = shrunk > 0 ? radii[shrunk / 2] : passes->radius;
    free(radii);
    return median;
}

int main(int count, char **arguments)
{
    Error error = {"usage: 5_radii SCENE SIZE PHOTONS PASSES PICTURE RADII NUMBERS"};
    Scene *scene = count == 8 && steps_load(NULL, &error) ? scene_load(arguments[1], &error) : NULL;
    FILE *numbers = scene ? fopen(arguments[7], "w") : NULL;
    if (!numbers)
        fail(error.message);
    RenderOptions options = {
        .integrator = INTEGRATOR_PHOTONS, .settings = scene->settings, .seed = 1, .glass_sides = 2};
    options.settings.width = options.settings.height = atoi(arguments[2]);
    options.settings.photons = atol(arguments[3]);
    options.settings.samples = 1;
    Passes passes = {.alpha = PASS_ALPHA, .by_pixel = true, .last = atoi(arguments[4])};
    RenderStats stats;
    Image image;
    if (!passes_run(scene, &options, &passes, &stats, &error) || !passes_picture(&passes, &image, &error) ||
        !image_write(&image, arguments[5], &error))
        fail(error.message);
    float median = draw(&passes, &image), by_pass = passes.radius;
    for (int i = 1; i <= passes.done; i++)
        by_pass = steps.next_radius(by_pass, i, passes.alpha);
    fprintf(numbers, "first_cm %.1f\nmedian_cm %.1f\nby_pass_cm %.1f\n", 100.0 * (double)passes.radius,
            100.0 * (double)median, 100.0 * (double)by_pass);
    if (!image_write(&image, arguments[6], &error))
        fail(error.message);
    image_free(&image);
    passes_free(&passes);
    scene_free(scene);
    return fclose(numbers) == 0 ? 0 : 1;
}
