#include "judge/checks/pictures.h"

#include "base/file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const int grids[] = {8, 2, 1};

PicturePlace picture_place(int feature)
{
    int grid = 0;
    for (; feature >= 3 * grids[grid] * grids[grid]; grid++)
        feature -= 3 * grids[grid] * grids[grid];
    int tile = feature / 3;
    return (PicturePlace){grids[grid], tile / grids[grid], tile % grids[grid], feature % 3};
}

// The fine tile that a number of the picture belongs to, times 3, plus its channel.
static int tile_of(int number, int side)
{
    int pixel = number / 3, across = side / 8;
    return (pixel / side / across * 8 + pixel % side / across) * 3 + number % 3;
}

void picture_features(const float *pixels, int side, double features[PICTURE_FEATURES])
{
    for (int i = 0; i < PICTURE_FEATURES; i++)
        features[i] = 0.0;
    double share = 64.0 / ((double)side * (double)side);
    for (int i = 0; i < side * side * 3; i++)
        features[tile_of(i, side)] += (double)pixels[i] * share;
    double *half = features + PICTURE_TILES * 3, *whole = half + 4 * 3;
    for (int i = 0; i < PICTURE_TILES * 3; i++) {
        int row = i / 24, column = i / 3 % 8;
        half[(row / 4 * 2 + column / 4) * 3 + i % 3] += features[i] / 16.0;
        whole[i % 3] += features[i] / 64.0;
    }
}

// The pixels' variance over K pictures, averaged over each fine tile.
static void variances(const PictureSet *set, const Numbers *pictures, double variance[PICTURE_TILES * 3])
{
    int count = set->side * set->side * 3;
    double share = 64.0 / ((double)set->side * (double)set->side);
    for (int i = 0; i < PICTURE_TILES * 3; i++)
        variance[i] = 0.0;
    for (int i = 0; i < count; i++) {
        double sum = 0.0, squares = 0.0;
        for (int r = 0; r < set->replicates; r++)
            sum += (double)pictures[r].values[i];
        double mean = sum / set->replicates;
        for (int r = 0; r < set->replicates; r++)
            squares += ((double)pictures[r].values[i] - mean) * ((double)pictures[r].values[i] - mean);
        variance[tile_of(i, set->side)] += squares / (set->replicates - 1) * share;
    }
}

static double log_variance(const PictureSet *set, const PictureReference *reference, const Numbers *pictures)
{
    double variance[PICTURE_TILES * 3], sum = 0.0;
    int tiles = 0;
    variances(set, pictures, variance);
    for (int i = 0; i < PICTURE_TILES * 3; i++) {
        if (reference->noise[i] <= 0.0)
            continue;
        sum += variance[i] / reference->noise[i];
        tiles++;
    }
    return tiles > 0 ? log(fmax(sum / tiles, 1e-30)) : 0.0;
}

static double standardised(double mean, double expected, double error)
{
    if (error > 0.0)
        return (mean - expected) / error;
    return mean == expected ? 0.0 : INFINITY;
}

void picture_score(const PictureSet *set, const PictureReference *reference, const Numbers *pictures,
                   PictureScore *score)
{
    *score = (PictureScore){.T = -1.0};
    for (int r = 0; r < set->replicates; r++) {
        double features[PICTURE_FEATURES];
        picture_features(pictures[r].values, set->side, features);
        for (int i = 0; i < PICTURE_FEATURES; i++)
            score->mean[i] += features[i] / set->replicates;
    }
    for (int i = 0; i < PICTURE_FEATURES; i++) {
        double error = reference->spread[i] / sqrt((double)set->replicates);
        score->z[i] = standardised(score->mean[i], reference->mean[i], error);
        if (fabs(score->z[i]) > score->T) {
            score->T = fabs(score->z[i]);
            score->worst = i;
        }
    }
    score->log_variance = log_variance(set, reference, pictures);
}

// ---- the file ----

// A number that changes with the scene's file; 0 when there is none to be read.
static uint64_t scene_hash(const PictureSet *set, const char *root)
{
    char path[4200];
    size_t size;
    Error ignored = {""};
    snprintf(path, sizeof path, "%s/%s", root, set->scene);
    char *text = file_read(path, 1u << 20, &size, &ignored);
    uint64_t hash = hash_text(0, text ? text : "");
    free(text);
    return hash;
}

// What the pictures were made of, as the file's first lines have it: a reference made of other things is of no use.
static void describe(const PictureSet *set, const char *root, char *text, size_t size)
{
    char kind[40] = ""; // left out of the others' files
    if (strcmp(set->kind, "picture") != 0)
        snprintf(kind, sizeof kind, "kind %s\n", set->kind);
    snprintf(
        text, size,
        "photonlab picture reference 1\n%sintegrator %s\nscene %s\nscene_hash %016llx\npixels %d x %d\nphotons %ld\nk %d\ndepth %d\n"
        "steps %s\nreplicates %d\n",
        kind, set->integrator, set->scene, (unsigned long long)scene_hash(set, root), set->side, set->side,
        set->photons, set->k, set->depth, set->steps, set->replicates);
}

bool picture_reference_write(const PictureSet *set, const char *path, const char *head,
                             const PictureReference *reference, Error *error)
{
    FileWriter writer;
    char parameters[512];
    if (!file_write_begin(&writer, path, error))
        return false;
    describe(set, ".", parameters, sizeof parameters);
    fprintf(writer.stream, "%s%s", parameters, head);
    fprintf(writer.stream, "T %.6g\nV %.6g\nV_upper %.6g\nV_spread %.6g\n", reference->T, reference->V,
            reference->V_upper, reference->V_spread);
    for (int i = 0; i < PICTURE_FEATURES; i++) {
        PicturePlace place = picture_place(i);
        fprintf(writer.stream, "tile %d %d %d %c %.9g %.9g", place.tiles, place.row, place.column, "rgb"[place.channel],
                reference -> mean[i], reference -> spread[i]);
        if (i < PICTURE_TILES * 3)
            fprintf(writer.stream, " %.9g", reference->noise[i]);
        fprintf(writer.stream, "\n");
    }
    return file_write_end(&writer, true, error);
}

static bool take(const char **at, const char *format, double *value)
{
    int length = 0;
    bool ok = sscanf(*at, format, value, &length) == 1 && length > 0;
    *at += ok ? length : 0;
    return ok;
}

static bool parse(const char *text, PictureReference *reference)
{
    const char *at = strstr(text, "\nT ");
    bool ok = at && take(&at, " T %lf%n", &reference->T) && take(&at, " V %lf%n", &reference->V) &&
              take(&at, " V_upper %lf%n", &reference->V_upper) && take(&at, " V_spread %lf%n", &reference->V_spread);
    for (int i = 0; ok && i < PICTURE_FEATURES; i++) {
        ok = take(&at, " tile %*d %*d %*d %*c %lf%n", &reference->mean[i]) &&
             take(&at, "%lf%n", &reference->spread[i]) &&
             (i >= PICTURE_TILES * 3 || take(&at, "%lf%n", &reference->noise[i]));
    }
    return ok;
}

bool picture_reference_read(const PictureSet *set, const char *root, PictureReference *reference, Error *error)
{
    char path[4200], parameters[512];
    size_t size;
    snprintf(path, sizeof path, "%s/tests/reference/pictures/%s.txt", root, set->name);
    char *text = file_read(path, 1u << 20, &size, error);
    if (!text)
        return false;
    describe(set, root, parameters, sizeof parameters);
    bool ok =
        strncmp(text, parameters, strlen(parameters)) == 0 ||
        error_set(error, "%s: was made for another scene or other parameters; make it anew: make calibrate", path);
    ok = ok && (parse(text, reference) || error_set(error, "%s: is damaged; make it anew: make calibrate", path));
    free(text);
    return ok;
}
