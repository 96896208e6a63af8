// Step 5.2: the mean over two runs of passes, (m·a + n·b)/(m + n).
#include "judge/checks/directions.h"

typedef struct {
    double a[3], m, b[3], n;
} Runs;

static const Runs known[] = {
    {{1, 2, 3}, 1, {3, 4, 5}, 1},
    {{1, 2, 3}, 4, {3, 4, 5}, 4},
    {{1, 1, 1}, 10, {12, 1, 0}, 1},
    {{12, 1, 0}, 1, {1, 1, 1}, 10},
    {{0.25, 0.5, 0.125}, 3, {0.75, 0.0625, 2}, 5},
    {{0.3, 0.2, 0.1}, 0, {0.7, 0.6, 0.9}, 3},
    {{0.3, 0.2, 0.1}, 6, {0.7, 0.6, 0.9}, 0},
    {{1e-4, 2e-4, 3e-4}, 1000, {5e-4, 1e-4, 9e-4}, 24},
    {{500, 0, 20}, 4096, {300, 100, 0}, 65536},
    {{2, 3, 4}, 1e6, {6, 5, 4}, 1e6},
};
#define KNOWN (int)(sizeof known / sizeof *known)
#define RUNS  (KNOWN + 14) // beyond the known ones, others with every salt
#define CALLS 2

// One pass more, as many more as there are, or any numbers of them.
static Runs runs_of(int i, uint64_t seed)
{
    if (i < KNOWN)
        return known[i];
    Runs r = {.m = floor(drawn_magnitude(seed, 20 * i, 1.01, 1e6))};
    r.n = i % 3 == 0 ? 1.0 : i % 3 == 1 ? r.m : floor(drawn_magnitude(seed, 20 * i + 1, 1.01, 1e6));
    for (int c = 0; c < 3; c++) {
        r.a[c] = drawn_magnitude(seed, 20 * i + 2 + c, 0.01, 100.0);
        r.b[c] = drawn_magnitude(seed, 20 * i + 5 + c, 0.01, 100.0);
    }
    return r;
}

static void plan_mean(Plan *plan)
{
    for (int i = 0; i < RUNS; i++) {
        Runs r = runs_of(i, plan->seed);
        plan_call(plan, CALLS, (double[]){r.a[0], r.a[1], r.a[2], r.m, r.b[0], r.b[1], r.b[2], r.n}, 8);
    }
}

// Returns the largest of what is averaged.
static double expect(const Runs *r, double mean[3])
{
    double largest = 0.0;
    for (int c = 0; c < 3; c++) {
        mean[c] = (r->m * r->a[c] + r->n * r->b[c]) / (r->m + r->n);
        largest = fmax(largest, fmax(r->a[c], r->b[c]));
    }
    return largest;
}

static void judge_mean(const Results *results, Finding *finding)
{
    for (int i = 0; i < RUNS; i++) {
        Runs r = runs_of(i, results->seed);
        double mean[3], largest = expect(&r, mean);
        const float *found = numbers_of(results, (size_t)i, 3 * CALLS, finding);
        const char *inputs = words("a = (%.5g, %.5g, %.5g) over %.0f passes, b = (%.5g, %.5g, %.5g) over %.0f", r.a[0],
                                   r.a[1], r.a[2], r.m, r.b[0], r.b[1], r.b[2], r.n);
        for (int call = 0; found && call < CALLS; call++)
            vector_is(found + 3 * call, vec3d(mean[0], mean[1], mean[2]), 2e-6 * largest, inputs, i, finding);
        for (int c = 0; i < KNOWN && c < 3; c++)
            finding_feature(finding, found ? ((double)found[c] - mean[c]) / largest : (double)NAN, 0.0);
    }
}

DEFINE_CHECKS(join_means, {"mean", "The mean over all passes", CHECK_VALUES, plan_mean, judge_mean},
              PICTURE_AND_V(5_pass))
