// Means and spreads of right code's pictures, and the thresholds that groups of K stay below.
#include "judge/checks/statistics.h"
#include "calibrate.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LEVEL 0.002 // of T and of V, each

// ---- means and spreads ----

static void keep_pixels(long group, const Results *pictures, void *data)
{
    float *all = data;
    size_t floats = pictures->cases[0].count;
    for (size_t r = 0; r < pictures->count; r++)
        memcpy(all + ((size_t)group * pictures->count + r) * floats, pictures->cases[r].values, floats * sizeof *all);
}

static void spread_of_features(const PictureSet *set, const float *all, long renders, PictureReference *reference)
{
    Sums sums[PICTURE_FEATURES] = {{0, 0, 0}};
    size_t floats = (size_t)set->side * (size_t)set->side * 3;
    for (long r = 0; r < renders; r++) {
        double features[PICTURE_FEATURES];
        picture_features(all + (size_t)r * floats, set->side, features);
        for (int i = 0; i < PICTURE_FEATURES; i++)
            sums_add(&sums[i], features[i]);
    }
    for (int i = 0; i < PICTURE_FEATURES; i++) {
        reference->mean[i] = sums_mean(&sums[i]);
        reference->spread[i] = sums_error(&sums[i]) * sqrt((double)renders);
    }
}

// The mean image; and its pixels' variances, which go through the tiles as radiance does.
static void spread_of_pixels(const PictureSet *set, const float *all, long renders, PictureReference *reference,
                             Image *mean)
{
    size_t floats = (size_t)set->side * (size_t)set->side * 3;
    float *variance = must(malloc(floats * sizeof *variance));
    for (size_t i = 0; i < floats; i++) {
        Sums sums = {0, 0, 0};
        for (long r = 0; r < renders; r++)
            sums_add(&sums, (double)all[(size_t)r * floats + i]);
        colour_set_channel(&mean->pixels[i / 3], (int)(i % 3), (float)sums_mean(&sums));
        double error = sums_error(&sums);
        variance[i] = (float)(error * error * (double)renders);
    }
    double features[PICTURE_FEATURES];
    picture_features(variance, set->side, features);
    memcpy(reference->noise, features, sizeof reference->noise);
    free(variance);
}

static bool find_spread(const Arguments *a, const PictureSet *set, PictureReference *reference, Image *mean)
{
    long groups = a->renders / set->replicates;
    size_t floats = (size_t)set->side * (size_t)set->side * 3;
    float *all = must(malloc((size_t)groups * (size_t)set->replicates * floats * sizeof *all));
    bool ok = groups_run(a, set, PURPOSE_SPREAD, groups, keep_pixels, all);
    if (ok) {
        spread_of_features(set, all, groups * set->replicates, reference);
        spread_of_pixels(set, all, groups * set->replicates, reference, mean);
    }
    free(all);
    return ok;
}

// ---- thresholds ----

typedef struct {
    const PictureSet *set;
    const PictureReference *reference;
    double *T, *log_variance; // group by group
} Scores;

static void keep_scores(long group, const Results *pictures, void *data)
{
    Scores *scores = data;
    PictureScore score;
    picture_score(scores->set, scores->reference, pictures->cases, &score);
    scores->T[group] = score.T;
    scores->log_variance[group] = score.log_variance;
}

// One group more stays below this with a probability of at least 1 − LEVEL, whatever the distribution (Vovk et al. 2005):
// it is as likely to take any of the n + 1 ranks. Sorts the values.
static double conformal_threshold(double *values, long count)
{
    sort_values(values, count);
    long rank = (long)ceil((double)(count + 1) * (1.0 - LEVEL));
    return values[rank - 1];
}

static bool find_thresholds(const Arguments *a, const PictureSet *set, PictureReference *reference)
{
    Scores scores = {set, reference, must(calloc((size_t)a->groups, sizeof(double))),
                     must(calloc((size_t)a->groups, sizeof(double)))};
    bool ok = groups_run(a, set, PURPOSE_THRESHOLDS, a->groups, keep_scores, &scores);
    Sums sums = {0, 0, 0};
    for (long i = 0; i < a->groups; i++)
        sums_add(&sums, scores.log_variance[i]);
    reference->V_spread = sums_error(&sums) * sqrt((double)a->groups);
    reference->T = conformal_threshold(scores.T, a->groups);
    reference->V_upper = conformal_threshold(scores.log_variance, a->groups);
    for (long i = 0; i < a->groups; i++)
        scores.log_variance[i] = fabs(scores.log_variance[i]);
    reference->V = conformal_threshold(scores.log_variance, a->groups);
    free(scores.T);
    free(scores.log_variance);
    return ok;
}

bool calibrate_set(const Arguments *a, const PictureSet *set)
{
    static PictureReference reference;
    char path[4300], head[200];
    Error error = {""};
    Image mean = {0, 0, NULL};
    double start = clock_seconds();
    if (!image_create(&mean, set->side, set->side, &error))
        return false;
    bool ok = find_spread(a, set, &reference, &mean) && find_thresholds(a, set, &reference);
    snprintf(head, sizeof head, "renders %ld\ngroups %ld\nseed %ld\n", a->renders / set->replicates * set->replicates,
             a->groups, a->seed);
    snprintf(path, sizeof path, "%s/%s.txt", a->out, set->name);
    ok = ok && picture_reference_write(set, path, head, &reference, &error);
    snprintf(path, sizeof path, "%s/%s.pfm", a->out, set->name);
    ok = ok && image_write_pfm(&mean, path, &error);
    image_free(&mean);
    if (!ok)
        fprintf(stderr, "calibrate: set %s: %s\n", set->name, error.message[0] ? error.message : "a probe failed");
    else
        printf("%-8s  T < %.2f   V < %.3f (upper tail alone: %.3f)   %.0f s\n", set->name, reference.T, reference.V,
               reference.V_upper, clock_seconds() - start);
    fflush(stdout);
    return ok;
}
