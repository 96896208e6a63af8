// Both views of a shrinking radius, at one point in even light: 5_views DATA NUMBERS
// DATA: passes, R/R_1 by step 5.1, and by 5.3 where the first pass finds 0.1, 3 and 100 photons on average. NUMBERS: what the
// radii have become, that the radiance of 5.3 and 5.4 is the mean of what each pass alone would say, and what wrong
// statistics come to after 1000 passes.
#include "photonlab.h"

#include <stdio.h>
#include <stdlib.h>

enum { PASSES = 1000, POINTS = 3, RUNS = 200 };

static const float alpha = 2.0f / 3.0f;
static const double first_found[POINTS] = {0.1, 3.0, 100.0};

// How many of many photons, by chance, where `mean` are expected (Poisson; Knuth's product).
static int draw_count(double mean, Rng *rng)
{
    int count = -1;
    double product = 1.0;
    do {
        product *= 1.0 - (double)rng_float(rng);
        count++;
    } while (product > exp(-mean));
    return count;
}

// In even light of radiance 1 with `first` photons in a disk of radius 1 m, each of them has this f_r·Φ, W/sr.
static Colour flux_of(int found, double first)
{
    return colour_grey((float)(found * (double)PI / first));
}

// ---- wrong statistics ----

typedef enum { RIGHT, FLUX_NOT_SCALED, FLUX_BY_RADIUS, OLD_SHARE, ALL_COUNTED, ALL_SHRINK, VARIANTS } Variant;

static const char *const variant_names[VARIANTS] = {"right",     "not_scaled",  "by_radius",
                                                    "old_share", "all_counted", "all_shrink"};

static PointStatistics add_by(Variant variant, PointStatistics point, int found, Colour flux)
{
    PointStatistics right = steps.add_photons(point, found, flux, alpha), p = right;
    float all = point.count + (float)found, shrunk = right.radius / point.radius;
    if (variant == FLUX_NOT_SCALED)
        p.flux = colour_add(point.flux, flux);
    if (variant == FLUX_BY_RADIUS)
        p.flux = colour_scale(colour_add(point.flux, flux), shrunk);
    if (variant == OLD_SHARE || variant == ALL_SHRINK) {
        p.count = variant == OLD_SHARE ? alpha * point.count + (float)found : alpha * all;
        float share = found > 0 ? p.count / all : 1.0f;
        p.radius = point.radius * sqrtf(share);
        p.flux = colour_scale(colour_add(point.flux, flux), share);
    }
    if (variant == ALL_COUNTED)
        p.count = all;
    return p;
}

// Means over many points.
static void try_variant(Variant variant, double first, FILE *numbers)
{
    double area = 0.0, radiance = 0.0;
    for (int r = 0; r < RUNS; r++) {
        Rng rng = rng_create(5, (uint64_t)r);
        PointStatistics point = {0.0f, 1.0f, {0.0f, 0.0f, 0.0f}};
        for (int i = 1; i <= PASSES; i++) {
            int found = draw_count(first * (double)(point.radius * point.radius), &rng);
            point = add_by(variant, point, found, flux_of(found, first));
        }
        area += (double)(point.radius * point.radius) / RUNS;
        radiance += (double)steps.point_radiance(point, PASSES).g / RUNS;
    }
    fprintf(numbers, "area_%s %.4f\nradiance_%s %.2f\n", variant_names[variant], area, variant_names[variant],
            radiance);
}

// ---- the two views ----

static void compare_radii(FILE *data, FILE *numbers)
{
    float radius = 1.0f;
    PointStatistics even = {0.0f, 1.0f, {0.0f, 0.0f, 0.0f}}, points[POINTS];
    Rng rngs[POINTS];
    for (int p = 0; p < POINTS; p++) {
        points[p] = even;
        rngs[p] = rng_create(6, (uint64_t)p);
    }
    for (int i = 1; i <= PASSES; i++) {
        fprintf(data, "%d %.5f", i, (double)radius);
        for (int p = 0; p < POINTS; p++) {
            double expected = first_found[p] * (double)(points[p].radius * points[p].radius);
            fprintf(data, " %.5f", (double)points[p].radius);
            int found = draw_count(expected, &rngs[p]);
            points[p] = steps.add_photons(points[p], found, flux_of(found, first_found[p]), alpha);
        }
        fprintf(data, "\n");
        if (i == 10 || i == 100 || i == PASSES)
            fprintf(numbers, "pass_%d %.6f\npixel_%d %.6f\nratio_%d %.4f\n", i, (double)(radius * radius), i,
                    (double)(even.radius * even.radius), i, (double)(even.radius * even.radius / (radius * radius)));
        even = steps.add_photons(even, (int)(1e6f * even.radius * even.radius + 0.5f), colour_grey(0.0f), alpha);
        radius = steps.next_radius(radius, i, alpha);
    }
}

// The same photons, counted by both: τ/(PπR²), and the mean of each pass's own Φ/(πR²).
static void compare_radiance(FILE *numbers)
{
    PointStatistics point = {0.0f, 1.0f, {0.0f, 0.0f, 0.0f}};
    Rng rng = rng_create(7, 0);
    Colour mean = colour_grey(0.0f);
    for (int i = 1; i <= PASSES; i++) {
        double light = 1.0 + 0.5 * sin((double)i); // it need not be even
        int found = draw_count(20.0 * light * (double)(point.radius * point.radius), &rng);
        Colour flux = flux_of(found, 20.0);
        Colour alone = colour_scale(flux, 1.0f / (PI * point.radius * point.radius));
        mean = steps.join_means(mean, i - 1, alone, 1);
        point = steps.add_photons(point, found, flux, alpha);
        if (i == 1 || i == 10 || i == PASSES)
            fprintf(numbers, "mean_%d %.5f\nstatistics_%d %.5f\n", i, (double)mean.g, i,
                    (double)steps.point_radiance(point, i).g);
    }
}

int main(int count, char **arguments)
{
    Error error = {""};
    FILE *data = count == 3 ? fopen(arguments[1], "w") : NULL, *numbers = count == 3 ? fopen(arguments[2], "w") : NULL;
    if (!data || !numbers || !steps_load(NULL, &error))
        return fprintf(stderr, "usage: 5_views DATA NUMBERS, both writable\n"), 2;
    compare_radii(data, numbers);
    compare_radiance(numbers);
    for (int v = 0; v < VARIANTS; v++)
        try_variant((Variant)v, 20.0, numbers);
    return fclose(data) == 0 && fclose(numbers) == 0 ? 0 : 1;
}
