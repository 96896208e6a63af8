// How a check of one step is written: it plans cases, the probe runs them on the student's code, it judges the numbers.
//
//   static void plan(Plan *plan) { plan_call(plan, 20000, (double[]){20.0}, 1); }
//   static void judge(const Results *results, Finding *finding) { … results->cases[0].values … finding_fail(…) … }
//   {"density", "Directions follow the lobe's density", CHECK_SAMPLES, plan, judge}
//
// A check says what it found in the student's terms ("expected …, found …"). Two ways to fail:
//   finding_fail       what right code never does, whatever its random numbers: wrong values, NaN, too long vectors
//   finding_p          a p-value of a test whose hypothesis right code fulfils exactly. The smallest one (times the
//                      number of tests) is held against the step's level, and a failure is confirmed with fresh
//                      random numbers before it counts
#pragma once

#include "photonlab.h"

#include <stddef.h>
#include <stdint.h>

typedef enum { CHECK_VALUES, CHECK_SAMPLES, CHECK_ENERGY, CHECK_INVARIANT, CHECK_PICTURE, CHECK_KINDS } CheckKind;
extern const char *const check_kind_names[CHECK_KINDS]; // "values", …

// The cases of checks that run together, in the order they were planned.
typedef struct {
    char **lines;
    size_t count, capacity;
    size_t first;     // the line at which this check's cases begin
    uint64_t seed;    // of this check in this round; case i takes hash_u64(seed + i)
    const char *step; // whose check it is
} Plan;
void plan_free(Plan *plan);

uint64_t hash_text(uint64_t hash, const char *text); // goes on from `hash`

// Memory that was asked for; without it the judge ends.
void *must(void *memory);

// Each returns the case's number within the check, from 0. Arguments of calls: as tests/judge/probe/ reads them; some begin
// with a scene.
size_t plan_call(Plan *plan, long count, const double *arguments, size_t argument_count);
size_t plan_call_in(Plan *plan, const char *scene, long count, const double *arguments, size_t argument_count);
size_t plan_paths(Plan *plan, const char *scene, long photons, long batches, int depth, const char *steps);
// `kind`: picture, or passes with what the probe reads behind it.
size_t plan_picture(Plan *plan, const char *kind, const char *integrator, const char *scene, int side, long photons,
                    int k, int depth, const char *steps);

// Inputs that nobody can know before: a float of [low, high] by the plan's seed, the same for the same use; and one whose
// logarithm is spread evenly.
double drawn_input(uint64_t seed, int use, double low, double high);
double drawn_magnitude(uint64_t seed, int use, double low, double high);

typedef struct {
    const float *values;
    size_t count;
} Numbers;

typedef struct {
    const Numbers *cases; // of this check, in the order planned
    size_t count;
    uint64_t seed; // the plan's, for inputs that were drawn from it
} Results;

#define MOST_FEATURES 160
#define MOST_BINS     40

// A number by which mistakes are told apart: 0 for right code, give or take its standard error. Features keep their
// order: the i-th is the same quantity in every run.
typedef struct {
    double value, error;
} Feature;

typedef struct {
    bool failed; // by finding_fail
    double p;    // the smallest p × tests; 1 when there was none
    int tests;   // how many p-values were given
    char message[600];
    char p_message[600];
    long failing_case; // within the check; −1: none in particular
    Feature features[MOST_FEATURES];
    int feature_count;
    // Of what was found over what was expected; and whether a 0 was expected, and not found.
    double lowest_ratio, highest_ratio;
    long ratios;
    bool not_zero;
    char suspected[40], suspicion[300]; // what the check makes of it where no known mistake fits: a name, and its words
    // For the report: a histogram over the analytic density.
    char histogram_title[80];
    double low, high, observed[MOST_BINS], expected[MOST_BINS];
    int bins;
    // A picture check's means, to look at; owned by the finding. The statistics against their thresholds.
    Image yours, reference;
    double T, T_threshold, V, V_threshold;
} Finding;

// Words for messages, printf style: a text that is good until this thread's eighth call from here.
const char *words(const char *format, ...) PRINTF_LIKE(1, 2);

// The first failure's message stays. `failing_case`: −1 when it is no single one's fault.
void finding_fail(Finding *finding, long failing_case, const char *format, ...) PRINTF_LIKE(3, 4);
// The message of the smallest p-value stays.
void finding_p(Finding *finding, double p, long failing_case, const char *format, ...) PRINTF_LIKE(4, 5);
void finding_feature(Finding *finding, double value, double error);
// A number as it was found and as it should be. Where all are the same factor off, the diagnosis says so.
void finding_ratio(Finding *finding, double found, double expected);
// The same for `count` of them.
void finding_ratios(Finding *finding, const float *found, const double *expected, int count);
// "looks like" words of the check's own, for what its numbers alone prove; the first one's stay.
void finding_suspect(Finding *finding, const char *name, const char *format, ...) PRINTF_LIKE(3, 4);
void finding_histogram(Finding *finding, const char *title, double low, double high, const double *observed,
                       const double *expected, int bins);

typedef struct {
    const char *name, *title;
    CheckKind kind;
    void (*plan)(Plan *plan);
    void (*judge)(const Results *results, Finding *finding);
} Check;

// The checks of one step.
typedef struct {
    const char *id;
    const Check *checks;
    const int *count;
} StepChecks;

extern const char *judge_root; // the checkout, absolute: where scenes and tests/reference/ lie
