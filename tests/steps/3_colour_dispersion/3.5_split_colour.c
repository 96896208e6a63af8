// Step 3.5: what becomes of white and of coloured photons in two kinds of glass.
#include "judge/checks/step_checks.h"

#include <string.h>

#define CALLS   2 // of each case
#define COLOURS 4
#define POWERS  4
#define NUMBERS 14 // of a photon: position, direction, power, colour, bounce, path, from, flown
static const double glasses[2][3] = {{1.2, 1.5, 2.4}, {1.5, 1.5, 1.5}}; // the second disperses nothing
static const double powers[POWERS - 1][3] = {{3.0, 2.0, 1.0}, {0.001, 0.002, 0.0045}, {0.0, 1.25, 0.0}};
static const char *const names[COLOURS] = {"white", "red", "green", "blue"};
static const char *const constants[COLOURS] = {"WHITE", "RED", "GREEN", "BLUE"};

// As the probe takes it and gives it back. The last of the powers comes from the seed.
static void photon_of(int number, uint64_t seed, double photon[NUMBERS])
{
    int colour = number % COLOURS, row = number / COLOURS % POWERS;
    const double start[NUMBERS] = {1.0 + number,   -2.5,       0.125,        0.0,         0.8,
                                   -0.6,           0.0,        0.0,          0.0,         colour,
                                   3 + number % 5, number % 3, number + 2.0, 0.5 + number};
    memcpy(photon, start, sizeof start);
    for (int c = 0; c < 3; c++) { // a coloured photon has its own channel alone
        double power = row < POWERS - 1 ? powers[row][c] : (double)(hash_u64(seed + (uint64_t)c) % 4000) / 1024.0;
        photon[6 + c] = colour == WHITE || colour == RED + c ? power : 0.0;
    }
}

static void plan_split(Plan *plan)
{
    for (int number = 0; number < 2 * POWERS * COLOURS; number++) {
        double arguments[3 + NUMBERS];
        memcpy(arguments, glasses[number / (POWERS * COLOURS)], sizeof glasses[0]);
        photon_of(number, plan->seed, arguments + 3);
        plan_call(plan, CALLS, arguments, 3 + NUMBERS);
    }
}

static bool same(const float *found, const double *expected, int count)
{
    for (int i = 0; i < count; i++)
        if (!(fabs((double)found[i] - expected[i]) <= 1e-6 * fabs(expected[i])))
            return false;
    return true;
}

static void judge_power(const float *child, const double power[3], const char *which, long number, Finding *finding)
{
    if (!same(child + 6, power, 3))
        finding_fail(finding, number, "expected power (%g, %g, %g) for %s; found (%g, %g, %g)", power[0], power[1],
                     power[2], which, (double)child[6], (double)child[7], (double)child[8]);
}

static void judge_rest(const float *child, const double *photon, const char *which, long number, Finding *finding)
{
    if (!same(child, photon, 6) || !same(child + 10, photon + 10, NUMBERS - 10))
        finding_fail(finding, number,
                     "expected %s to keep position, direction and everything but power and colour; found it changed",
                     which);
}

static void judge_white(const float *children, const double *photon, long number, Finding *finding)
{
    static const char *const which[3] = {"the first child, red", "the second child, green", "the third child, blue"};
    for (int c = 0; c < 3; c++) {
        const float *child = children + c * NUMBERS;
        double power[3] = {0.0, 0.0, 0.0};
        power[c] = photon[6 + c];
        if (child[9] != (float)(RED + c))
            finding_fail(finding, number, "expected %s, to have colour %s; found %s", which[c], constants[RED + c],
                         child[9] >= 0.0f && child[9] < COLOURS ? constants[(int)child[9]] : "none of the four");
        judge_power(child, power, which[c], number, finding);
        judge_rest(child, photon, which[c], number, finding);
    }
}

static void judge_single(const float *child, const double *photon, long number, Finding *finding)
{
    if ((double)child[9] != photon[9])
        finding_fail(finding, number, "expected a %s photon that does not split to keep its colour; found another",
                     names[(int)photon[9]]);
    judge_power(child, photon + 6, "a photon that does not split", number, finding);
    judge_rest(child, photon, "a photon that does not split", number, finding);
}

// Of one case: how many too many; then, of the first two children, colours, what was flown, and powers against what they
// must be.
static void features(const float *values, int expected, const double *photon, Finding *finding)
{
    finding_feature(finding, values ? (double)values[0] - expected : (double)NAN, 0.0);
    for (int i = 0; i < 2; i++) {
        const float *child = values ? values + 1 + i * NUMBERS : NULL;
        bool there = child && i < expected && (float)i < values[0];
        finding_feature(finding, there ? (double)child[9] - (expected == 3 ? RED + i : photon[9]) : (double)NAN, 0.0);
        finding_feature(finding, there ? (double)child[NUMBERS - 1] - photon[NUMBERS - 1] : (double)NAN, 0.0);
        for (int c = 0; c < 3; c++) {
            double power = expected == 1 || c == i ? photon[6 + c] : 0.0;
            finding_feature(finding, there ? (double)child[6 + c] - power : (double)NAN, 0.0);
        }
    }
}

static void judge_split(const Results *results, Finding *finding)
{
    for (int number = 0; number < 2 * POWERS * COLOURS; number++) {
        const Numbers *numbers = &results->cases[number];
        const float *values = numbers->values && numbers->count == CALLS * (1 + 3 * NUMBERS) ? numbers->values : NULL;
        double photon[NUMBERS];
        photon_of(number, results->seed, photon);
        if (values && memcmp(values, values + 1 + 3 * NUMBERS, (1 + 3 * NUMBERS) * sizeof *values) != 0)
            finding_fail(
                finding, number,
                "expected the same children from the same photon; found others when asked a second time: is the "
                "photon that was given changed, or something remembered?");
        bool disperses = number < POWERS * COLOURS;
        int expected = disperses && photon[9] == WHITE ? 3 : 1;
        if (!values || values[0] != (float)expected)
            finding_fail(finding, number, "expected a %s photon in %s to become %d; found %g", names[(int)photon[9]],
                         disperses ? "dispersing glass" : "glass of a single index", expected,
                         values ? (double)values[0] : (double)NAN);
        else if (expected == 3)
            judge_white(values + 1, photon, number, finding);
        else
            judge_single(values + 1, photon, number, finding);
        if (number / COLOURS % POWERS == 0 && photon[9] <= RED)
            features(values, expected, photon, finding);
    }
}

DEFINE_CHECKS(split_colour,
              {"split", "White splits once, into one photon of each colour", CHECK_VALUES, plan_split, judge_split},
              PICTURE(3))
