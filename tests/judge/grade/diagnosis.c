// Names the mistake that a failing step looks like, or none: a wrong name costs a student more than silence.
//
// Known mistakes: tests/mistakes/features.txt, made by `make mistakes-table` from the a patches. Three lines an entry:
//   STEP NAME                     "2.1 n_for_n_plus_1"; the name `right` is the solution
//   what it looks like            completes "this looks like: …"
//   CHECK:value:error …           the features in the order of the checks; values may be nan or inf
#include "judge/grade/grade.h"
#include "base/file.h"
#include "judge/report/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Features differ by chance (ERRORS standard errors: there are hundreds of them), by rounding, and because two people
// write the same mistake a little differently.
#define ERRORS   4.5
#define RELATIVE 0.01
#define ABSOLUTE 1e-4

// It is named when its worst feature is this many tolerances away at most, and that of the next best, if it has another
// text, more than that and CLEARLY times as many.
#define AGREES  1.5
#define CLEARLY 2.0

// What the checks of one step measured, one after the other.
typedef struct {
    const char *check;
    const Feature *feature;
} Measured;

static int measured_by(const StepResult *result, Measured *found)
{
    int count = 0;
    for (int i = 0; i < result->check_count; i++) {
        const CheckResult *check = &result->checks[i];
        if (check->check->kind == CHECK_PICTURE)
            continue; // it is calibrated apart from the table
        for (int f = 0; f < check->finding.feature_count; f++)
            found[count++] = (Measured){check->check->name, &check->finding.features[f]};
    }
    return count;
}

static double feature_distance(const Feature *a, const Feature *b)
{
    if (isnan(a->value) || isnan(b->value))
        return isnan(a->value) && isnan(b->value) ? 0.0 : INFINITY;
    if (isinf(a->value) || isinf(b->value))
        return a->value == b->value ? 0.0 : INFINITY;
    // The table's errors are those of one grading, seen from several: they stand in for what a check does not state.
    double of_a = isfinite(a->error) ? a->error : 0.0, of_b = isfinite(b->error) ? b->error : 0.0;
    double chance = ERRORS * fmax(of_a, of_b) * 1.1;
    double tolerance = chance + RELATIVE * fmax(fabs(a->value), fabs(b->value)) + ABSOLUTE;
    return fabs(a->value - b->value) / tolerance;
}

// The worst feature of a line of the table, which is cut up, in tolerances: up to 1 they agree. INFINITY: not the same
// features, as where one of them left a check early.
static double distance_to(char *line, const Measured *found, int count)
{
    double worst = 0.0;
    int i = 0;
    char *rest, *end;
    for (char *word = strtok_r(line, " \n", &rest); word; word = strtok_r(NULL, " \n", &rest), i++) {
        size_t name = strcspn(word, ":"); // "density:0.013:0.0004"
        if (i == count || !word[name] || strncmp(word, found[i].check, name) != 0 || found[i].check[name])
            return INFINITY;
        Feature known = {.value = strtod(word + name + 1, &end)};
        if (end == word + name + 1 || *end != ':')
            return INFINITY;
        known.error = strtod(end + 1, NULL);
        worst = fmax(worst, feature_distance(found[i].feature, &known));
    }
    return i == count ? worst : INFINITY;
}

typedef struct {
    char name[64], text[300];
    double distance, next; // of the best, and of the best with another text
} Ranking;

static void rank(Ranking *best, const char *name, const char *text, double distance)
{
    if (strcmp(text, best->text) != 0) // there are several ways to make one mistake
        best->next = fmin(best->next, fmax(distance, best->distance));
    if (distance >= best->distance)
        return;
    snprintf(best->name, sizeof best->name, "%s", name);
    snprintf(best->text, sizeof best->text, "%s", text);
    best->distance = distance;
}

#define FEWEST_RATIOS 6
#define SAME_RATIO    2e-3

// All that a failing check compared is the same factor off: that is a fact, whatever it comes from.
static bool find_factor(const Finding *finding, StepResult *result)
{
    static const struct {
        double factor;
        const char *words;
    } known[] = {
        {3.14159265, "π times"},   {0.318309886, "1/π of"},     {6.2831853, "2π times"}, {0.159154943, "1/(2π) of"},
        {12.5663706, "4π times"},  {0.0795774715, "1/(4π) of"}, {9.8696044, "π² times"}, {0.101321184, "1/π² of"},
        {1.57079633, "π/2 times"}, {0.636619772, "2/π of"},     {2.0, "twice"},          {0.5, "half of"},
        {3.0, "three times"},      {1.0 / 3.0, "a third of"},   {4.0, "four times"},     {0.25, "a quarter of"},
        {-1.0, "the opposite of"}};
    double low = finding->lowest_ratio, high = finding->highest_ratio, mean = 0.5 * (low + high);
    if (finding->ratios < FEWEST_RATIOS || finding->not_zero || !(high - low <= SAME_RATIO * fabs(mean)) ||
        !(fabs(mean) > 1e-30) || fabs(mean - 1.0) < 2.0 * SAME_RATIO)
        return false;
    char times[40];
    snprintf(times, sizeof times, "%.4g times", mean);
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (fabs(mean / known[i].factor - 1.0) < SAME_RATIO)
            snprintf(times, sizeof times, "%s", known[i].words);
    snprintf(result->mistake, sizeof result->mistake, "factor");
    snprintf(result->looks_like, sizeof result->looks_like,
             "all results are %s what they should be, whatever goes in: a factor that is missing, or one too many",
             times);
    return true;
}

// What the numbers of the failing checks prove by themselves.
static void suspect(StepResult *result)
{
    for (int i = 0; i < result->check_count && !*result->mistake; i++) {
        const Finding *finding = &result->checks[i].finding;
        if (result->checks[i].status != STATUS_FAIL || find_factor(finding, result))
            continue;
        snprintf(result->mistake, sizeof result->mistake, "%s", finding->suspected);
        snprintf(result->looks_like, sizeof result->looks_like, "%s", finding->suspicion);
    }
}

static void find_tile(const GradeOptions *options, StepResult *result)
{
    char path[4096], anchor[100], wanted[110];
    size_t size;
    Error none = {""};
    snprintf(path, sizeof path, "%s/course_notes/gallery.md", options->root);
    char *gallery = file_read(path, 4u << 20, &size, &none);
    text_of_tile(result->step->id, result->mistake, anchor, sizeof anchor);
    snprintf(wanted, sizeof wanted, "#%s}", anchor);
    if (gallery && strstr(gallery, wanted))
        snprintf(result->tile, sizeof result->tile, "%s", anchor);
    free(gallery);
}

void diagnose(const GradeOptions *options, StepResult *result)
{
    char path[4096], step[8], name[64], text[300], *line = NULL;
    size_t capacity = 0;
    snprintf(path, sizeof path, "%s/tests/mistakes/features.txt", options->root);
    FILE *stream = fopen(path, "r");
    if (!stream)
        return;
    Measured found[MOST_CHECKS * MOST_FEATURES];
    Ranking best = {.distance = INFINITY, .next = INFINITY};
    int count = measured_by(result, found);
    while (getline(&line, &capacity, stream) > 0 && sscanf(line, "%7s %63s", step, name) == 2 &&
           getline(&line, &capacity, stream) > 0) {
        snprintf(text, sizeof text, "%.*s", (int)strcspn(line, "\n"), line);
        if (getline(&line, &capacity, stream) > 0 && strcmp(step, result->step->id) == 0)
            rank(&best, name, text, distance_to(line, found, count));
    }
    free(line);
    fclose(stream);
    if (best.distance <= AGREES && best.next > AGREES && best.next >= CLEARLY * best.distance &&
        strcmp(best.name, "right") != 0) {
        snprintf(result->mistake, sizeof result->mistake, "%s", best.name);
        snprintf(result->looks_like, sizeof result->looks_like, "%s", best.text);
    }
    if (!*result->mistake)
        suspect(result);
    if (*result->mistake)
        find_tile(options, result);
}
