// Plans K pictures and judges them. What is measured: pictures.h.
#include "judge/checks/pictures.h"
#include "judge/checks/step_checks.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PICTURE_SET(set, title, ...) {#set, __VA_ARGS__},
const PictureSet picture_sets[PICTURE_SETS] = {
#include "judge/checks/pictures.def"
};

void picture_set_plan(const PictureSet *set, Plan *plan)
{
    for (int i = 0; i < set->replicates; i++)
        plan_picture(plan, set->kind, set->integrator, set->scene, set->side, set->photons, set->k, set->depth,
                     set->steps);
}

// ---- what right code never gives ----

// Of few single wavelengths a pixel may have less than nothing of a colour: no screen shows them alone.
static bool is_spectral(const PictureSet *set)
{
    return strstr(set->steps, "6.4") != NULL;
}

static void check_pixels(const PictureSet *set, const Numbers *picture, long replicate, Finding *finding)
{
    for (int i = 0; i < set->side * set->side * 3; i++) {
        double value = (double)picture->values[i];
        int pixel = i / 3;
        if (!isfinite(value) || (value < 0.0 && !is_spectral(set))) {
            finding_fail(finding, replicate,
                         "expected radiance of 0 or more in every pixel; found %g %s in column %d, row %d", value,
                         i % 3 == 0   ? "red"
                         : i % 3 == 1 ? "green"
                                      : "blue",
                         pixel % set->side, pixel / set->side);
            return;
        }
    }
}

static bool is_black(const PictureSet *set, const Numbers *picture)
{
    for (int i = 0; i < set->side * set->side * 3; i++)
        if (picture->values[i] != 0.0f)
            return false;
    return true;
}

static bool pictures_are_sound(const PictureSet *set, const Results *results, Finding *finding)
{
    size_t floats = (size_t)set->side * (size_t)set->side * 3;
    bool all_black = true;
    for (size_t i = 0; i < results->count; i++) {
        if (results->cases[i].count != floats) {
            finding_fail(finding, (long)i, "expected a picture of %d × %d pixels; found %zu numbers", set->side,
                         set->side, results->cases[i].count);
            return false;
        }
        check_pixels(set, &results->cases[i], (long)i, finding);
        all_black = all_black && is_black(set, &results->cases[i]);
    }
    if (all_black)
        finding_fail(finding, -1, "expected a picture; found it black in every pixel");
    for (size_t i = 0; i < results->count; i++)
        for (size_t j = 0; j < i; j++)
            if (memcmp(results->cases[i].values, results->cases[j].values, floats * sizeof(float)) == 0)
                finding_fail(finding, (long)i,
                             "expected pictures whose noise follows the random numbers; found the same picture twice");
    return !finding->failed;
}

// ---- words ----

static const char *part_of_picture(PicturePlace place, char *text, size_t size)
{
    static const char *const heights[] = {"top", "upper", "upper", "middle", "middle", "lower", "lower", "bottom"};
    static const char *const sides[] = {"left", "left", "left", "centre", "centre", "right", "right", "right"};
    snprintf(text, size, "the whole picture");
    if (place.tiles == 2)
        snprintf(text, size, "the %s %s quarter", place.row == 0 ? "upper" : "lower",
                 place.column == 0 ? "left" : "right");
    if (place.tiles == 8)
        snprintf(text, size, "a tile at the %s %s (column %d, row %d of 8 × 8)", heights[place.row],
                 sides[place.column], place.column + 1, place.row + 1);
    return text;
}

// Are all three channels of this tile off the same way, none much less than another?
static bool is_off_in_all(const PictureScore *score, int feature)
{
    const double *z = score->z + feature / 3 * 3;
    double least = fmin(fabs(z[0]), fmin(fabs(z[1]), fabs(z[2])));
    return z[0] * z[1] > 0.0 && z[1] * z[2] > 0.0 && least > 0.4 * fabs(score->z[feature]);
}

// "the lower left quarter is 12 % too dark", "has 12 % too little red", "is 4 times too bright"
static void describe_feature(const PictureReference *reference, const PictureScore *score, int feature, char *text,
                             size_t size)
{
    static const char *const colours[] = {"red", "green", "blue"};
    char words[96], amount[64];
    PicturePlace place = picture_place(feature);
    const char *part = part_of_picture(place, words, sizeof words);
    double ratio = score->mean[feature] / reference->mean[feature];
    double percent = 100.0 * fabs(ratio - 1.0);
    if (ratio > 2.5)
        snprintf(amount, sizeof amount, "%.*f times", ratio < 9.5 ? 1 : 0, ratio);
    else
        snprintf(amount, sizeof amount, "%.*f %%", percent < 9.5 ? 1 : 0, percent);
    if (!(reference->mean[feature] > 0.0))
        snprintf(text, size, "%s should be black and is lit", part);
    else if (is_off_in_all(score, feature))
        snprintf(text, size, "%s is %s too %s", part, amount, ratio > 1.0 ? "bright" : "dark");
    else
        snprintf(text, size, "%s has %s too %s %s", part, amount, ratio > 1.0 ? "much" : "little",
                 colours[place.channel]);
}

// The worst feature of the coarsest grid that is beyond the threshold: "the whole picture" says more than one tile of it.
static int telling_feature(const PictureReference *reference, const PictureScore *score)
{
    int coarse = score->worst;
    for (int i = 0; i < PICTURE_FEATURES; i++) {
        int tiles = picture_place(i).tiles, best = picture_place(coarse).tiles;
        if (fabs(score->z[i]) > reference->T &&
            (tiles < best || (tiles == best && fabs(score->z[i]) > fabs(score->z[coarse]))))
            coarse = i;
    }
    return coarse;
}

static void judge_T(const PictureReference *reference, const PictureScore *score, Finding *finding)
{
    char first[160], worst[200] = "";
    int telling = telling_feature(reference, score);
    describe_feature(reference, score, telling, first, sizeof first);
    if (telling != score->worst) {
        snprintf(worst, sizeof worst, ", and ");
        describe_feature(reference, score, score->worst, worst + 6, sizeof worst - 6);
    }
    finding_p(finding, score->T > reference->T ? 0.0 : 1.0, -1,
              "wrong picture: %s%s (the worst patch is T = %.1f standard deviations off; right code stays below %.1f)",
              first, worst, score->T, reference->T);
}

static void judge_V(const PictureReference *reference, const PictureScore *score, Finding *finding)
{
    double ratio = exp(score->log_variance);
    finding_p(
        finding, fabs(score->log_variance) > reference->V ? 0.0 : 1.0, -1,
        "right picture, but from another estimator: its noise has %.2f times the variance that it should have "
        "(V = %.2f, that in logarithms; right code stays below %.2f). Look at the number of photons, the radius and the filter",
        ratio, fabs(score->log_variance), reference->V);
}

// ---- the verdict ----

static void give_features(const PictureSet *set, const PictureReference *reference, const PictureScore *score,
                          Finding *finding)
{
    for (int i = PICTURE_TILES * 3; i < PICTURE_FEATURES; i++) {
        double scale = fmax(reference->mean[i], 1e-9);
        finding_feature(finding, (score->mean[i] - reference->mean[i]) / scale,
                        reference->spread[i] / scale / sqrt((double)set->replicates));
    }
    finding_feature(finding, score->log_variance, reference->V_spread);
}

static void keep_pictures(const PictureSet *set, const Results *results, Finding *finding, Error *error)
{
    char path[4200];
    snprintf(path, sizeof path, "%s/tests/reference/pictures/%s.pfm", judge_root, set->name);
    if (!image_read(&finding->reference, path, error) || !image_create(&finding->yours, set->side, set->side, error))
        return;
    for (size_t r = 0; r < results->count; r++) {
        const float *value = results->cases[r].values;
        for (int i = 0; i < set->side * set->side; i++, value += 3) {
            Colour share = colour_scale(colour(value[0], value[1], value[2]), 1.0f / (float)results->count);
            finding->yours.pixels[i] = colour_add(finding->yours.pixels[i], share);
        }
    }
}

void picture_set_judge(const PictureSet *set, bool V_counts, const Results *results, Finding *finding)
{
    Error error = {""};
    PictureReference reference;
    PictureScore score;
    if (!picture_reference_read(set, judge_root, &reference, &error)) {
        // Nobody's fault who is graded here, and no verdict can be had: a checkout that is damaged.
        fprintf(stderr, "judge: %s\n", error.message);
        exit(3);
    }
    keep_pictures(set, results, finding, &error);
    if (!pictures_are_sound(set, results, finding))
        return;
    picture_score(set, &reference, results->cases, &score);
    finding->T = score.T;
    finding->T_threshold = reference.T;
    finding->V = V_counts ? fabs(score.log_variance) : score.log_variance;
    finding->V_threshold = V_counts ? reference.V : reference.V_upper;
    judge_T(&reference, &score, finding);
    if (V_counts && score.T <= reference.T)
        judge_V(&reference, &score, finding);
    give_features(set, &reference, &score, finding);
}

#define PICTURE_SET(set, title, ...)                                                                                   \
    const char picture_title_##set[] = title;                                                                          \
    void plan_picture_##set(Plan *plan)                                                                                \
    {                                                                                                                  \
        picture_set_plan(&picture_sets[PICTURE_SET_##set], plan);                                                      \
    }                                                                                                                  \
    void judge_picture_##set(const Results *results, Finding *finding)                                                 \
    {                                                                                                                  \
        picture_set_judge(&picture_sets[PICTURE_SET_##set], false, results, finding);                                  \
    }                                                                                                                  \
    void judge_picture_and_v_##set(const Results *results, Finding *finding)                                           \
    {                                                                                                                  \
        picture_set_judge(&picture_sets[PICTURE_SET_##set], true, results, finding);                                   \
    }
#include "judge/checks/pictures.def"
