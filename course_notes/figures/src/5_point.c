// Progressive photon mapping at one point (Knaus & Zwicker 2011): passes whose radius shrinks are averaged; and mistakes in it.
//   5_point DATA NUMBERS
// The photons lie on a disk of radius 1 m about the point, where the irradiance is 1 + s² at distance s: the truth in
// the middle is 1, and an estimate with radius r sees 1 + r²/2. Repeated with many seeds; DATA: passes, then for each
// rule the radius by its first value, and the rms error.
#include "photonlab.h"

#include <stdio.h>
#include <stdlib.h>

enum { PHOTONS = 100, PASSES = 10000, RUNS = 400, MARKS = 41, RULES = 9 };

// What r² is multiplied by after pass i.
static double right(int i, double alpha)
{
    return (i + alpha) / (i + 1.0);
}
static double from_zero(int i, double alpha)
{
    return (i - 1 + alpha) / i;
}
static double root_missing(int i, double alpha)
{
    return right(i, alpha) * right(i, alpha);
}
static double times_alpha(int i, double alpha)
{
    return (alpha * i + 1.0) / (i + 1.0);
}
static double upside_down(int i, double alpha)
{
    return 1.0 / right(i, alpha);
}

typedef struct {
    const char *name;
    double alpha;
    double (*factor)(int i, double alpha);
    enum { OWN_SEEDS, SAME_SEED, LAST_ONLY } passes;
} Rule;

static const Rule rules[RULES] = {
    {"third", 1.0 / 3.0, right, OWN_SEEDS},
    {"two_thirds", 2.0 / 3.0, right, OWN_SEEDS},
    {"one", 1.0, right, OWN_SEEDS},
    {"from_zero", 2.0 / 3.0, from_zero, OWN_SEEDS},
    {"root_missing", 2.0 / 3.0, root_missing, OWN_SEEDS},
    {"times_alpha", 2.0 / 3.0, times_alpha, OWN_SEEDS},
    {"upside_down", 2.0 / 3.0, upside_down, OWN_SEEDS},
    {"same_seed", 2.0 / 3.0, right, SAME_SEED},
    {"last_only", 2.0 / 3.0, right, LAST_ONLY},
};
static const double first_radius2 = 0.25; // m²

// From 1 to PASSES, evenly on a log axis, each once.
static int list_marks(int marks[MARKS])
{
    int count = 0;
    for (int i = 0; i < MARKS; i++) {
        int mark = (int)(pow(PASSES, (double)i / (MARKS - 1)) + 0.5);
        if (count == 0 || mark > marks[count - 1])
            marks[count++] = mark;
    }
    return count;
}

// One pass: the estimate from the photons within the radius. s² of a uniform point on the disk is uniform, in steps of 2⁻²⁴:
// in a smaller disk nothing will be found.
static double estimate(double radius2, Rng *rng)
{
    double sum = 0.0;
    for (int i = 0; i < PHOTONS; i++) {
        double s2 = (double)rng_float(rng);
        if (s2 < radius2)
            sum += 1.0 + s2;
    }
    return radius2 > 0x1p-24 ? sum / (PHOTONS * radius2) : 0.0; // Φ = (1 + s²)·π/PHOTONS, over πr²
}

// What one run says at the marks.
static void run(const Rule *rule, uint64_t number, const int *marks, double *found)
{
    Rng rng = rng_create(5, number);
    Rng first = rng;
    double radius2 = first_radius2, sum = 0.0;
    for (int i = 1, m = 0; i <= PASSES; i++) {
        if (rule->passes == SAME_SEED)
            rng = first;
        double one = estimate(radius2, &rng);
        sum += one;
        if (i == marks[m])
            found[m++] = rule->passes == LAST_ONLY ? one : sum / i;
        radius2 *= rule->factor(i, rule->alpha);
    }
}

// Both over all runs, at the marks.
static void run_all(int number, const int *marks, int mark_count, double *rms, double *means)
{
    double found[MARKS] = {0.0};
    for (int r = 0; r < RUNS; r++) {
        run(&rules[number], (uint64_t)(number * RUNS + r), marks, found);
        for (int m = 0; m < mark_count; m++) {
            rms[m] += (found[m] - 1.0) * (found[m] - 1.0);
            means[m] += found[m] / RUNS;
        }
    }
    for (int m = 0; m < mark_count; m++)
        rms[m] = sqrt(rms[m] / RUNS);
}

static double area_at(const Rule *rule, int pass)
{
    double ratio = 1.0;
    for (int i = 1; i < pass; i++)
        ratio *= rule->factor(i, rule->alpha);
    return ratio;
}

int main(int count, char **arguments)
{
    FILE *data = count == 3 ? fopen(arguments[1], "w") : NULL, *numbers = count == 3 ? fopen(arguments[2], "w") : NULL;
    if (!data || !numbers)
        return fprintf(stderr, "usage: 5_point DATA NUMBERS, both writable\n"), 2;
    int marks[MARKS], mark_count = list_marks(marks), thousand = 0, hundred = 0;
    static double rms[RULES][MARKS], means[RULES][MARKS];
    for (int rule = 0; rule < RULES; rule++)
        run_all(rule, marks, mark_count, rms[rule], means[rule]);
    for (int m = 0; m < mark_count; m++) {
        fprintf(data, "%d", marks[m]);
        for (int rule = 0; rule < RULES; rule++)
            fprintf(data, " %.5g %.5f", sqrt(area_at(&rules[rule], marks[m])), rms[rule][m]);
        fprintf(data, "\n");
        thousand = marks[m] <= 1000 ? m : thousand;
        hundred = marks[m] <= 100 ? m : hundred;
    }
    for (int rule = 0; rule < RULES; rule++) {
        const char *name = rules[rule].name;
        double fall = log(rms[rule][mark_count - 1] / rms[rule][hundred]);
        fprintf(numbers, "area_1000_%s %.6f\nradius_1000_%s %.3f\n", name, area_at(&rules[rule], 1000), name,
                sqrt(area_at(&rules[rule], 1000)));
        fprintf(numbers, "slope_%s %.2f\nrms_1000_%s %.4f\nrms_%s %.4f\nmean_%s %.3f\n", name,
                fall / log((double)PASSES / marks[hundred]), name, rms[rule][thousand], name, rms[rule][mark_count - 1],
                name, means[rule][mark_count - 1]);
    }
    return fclose(data) == 0 && fclose(numbers) == 0 ? 0 : 1;
}
