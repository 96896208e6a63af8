// Does the order matter in which passes are joined? 5_order SCENE PASSES NUMBERS
// Each pass is rendered alone; then all are joined by step 5.2: two by two, as the library does it; one after the other; and
// one after the other from behind. NUMBERS: in how many of a hundred pixels a picture differs from the first.
#include "photonlab.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIZE = 64, MOST = 64 };

static Image passes[MOST];

static void fail(const char *message)
{
    fprintf(stderr, "5_order: %s\n", message);
    exit(1);
}

static Image render_alone(const Scene *scene, int number)
{
    Error error = {""};
    RenderStats stats;
    Image image;
    RenderOptions options = {
        .integrator = INTEGRATOR_PHOTONS, .settings = scene->settings, .seed = 1, .glass_sides = 2};
    options.settings.width = options.settings.height = SIZE;
    options.settings.photons = 5000;
    options.settings.samples = 1;
    options.settings.radius = 0.1f;
    Passes one = {.alpha = PASS_ALPHA, .first = number, .last = number + 1};
    if (!passes_run(scene, &options, &one, &stats, &error) || !passes_picture(&one, &image, &error))
        fail(error.message);
    passes_free(&one);
    return image;
}

// The mean of passes first … first+count−1, count a power of 2.
static Colour two_by_two(int pixel, int first, int count)
{
    if (count == 1)
        return passes[first].pixels[pixel];
    Colour left = two_by_two(pixel, first, count / 2);
    Colour right = two_by_two(pixel, first + count / 2, count / 2);
    return steps.join_means(left, count / 2, right, count / 2);
}

static Colour in_a_row(int pixel, int count, bool backwards)
{
    Colour mean = colour_grey(0.0f);
    for (int i = 0; i < count; i++)
        mean = steps.join_means(mean, i, passes[backwards ? count - 1 - i : i].pixels[pixel], 1);
    return mean;
}

int main(int count, char **arguments)
{
    Error error = {""};
    int all = count == 4 ? atoi(arguments[2]) : 0;
    Scene *scene = all >= 1 && all <= MOST && steps_load(NULL, &error) ? scene_load(arguments[1], &error) : NULL;
    FILE *numbers = scene ? fopen(arguments[3], "w") : NULL;
    if (!numbers)
        fail(error.message[0] ? error.message : "usage: 5_order SCENE PASSES NUMBERS");
    for (int i = 0; i < all; i++)
        passes[i] = render_alone(scene, i);
    int differs[2] = {0, 0};
    float most = 0.0f;
    for (int pixel = 0; pixel < SIZE * SIZE; pixel++) {
        Colour first = two_by_two(pixel, 0, all);
        for (int b = 0; b < 2; b++) {
            Colour other = in_a_row(pixel, all, b == 1);
            differs[b] += memcmp(&first, &other, sizeof first) != 0;
            most = fmaxf(most, fabsf(other.g / first.g - 1.0f));
        }
    }
    fprintf(numbers, "row_percent %.0f\nbackwards_percent %.0f\nmost_ppm %.1f\n", 100.0 * differs[0] / (SIZE * SIZE),
            100.0 * differs[1] / (SIZE * SIZE), 1e6 * (double)most);
    scene_free(scene);
    return fclose(numbers) == 0 ? 0 : 1;
}
