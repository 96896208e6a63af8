// Step 5.2: the mean over two runs of passes, (m·a + n·b)/(m + n).
#include "judge/checks/directions.h"

#include <stdio.h>

typedef struct {
    double a[3], m, b[3], n;
} Runs;

static const Runs runs[] = {
    {{1, 2, 3}, 1, {3, 4, 5}, 1},
    {{1, 2, 3}, 4, {3, 4, 5}, 4},
    {{1, 1, 1}, 10, {12, 1, 0}, 1},
    {{12, 1, 0}, 1, {1, 1, 1}, 10},
    {{0.25, 0.5, 0.125}, 3, {0.75, 0.0625, 2}, 5},
    {{0.3, 0.2, 0.1}, 0, {0.7, 0.6, 0.9}, 3},
    {{0.3, 0.2, 0.1}, 6, {0.7, 0.6, 0.9}, 0},
    {{1e-4, 2e-4, 3e-4}, 1000, {5e-4, 1e-4, 9e-4}, 24},
    {{500, 0, 20}, 4096, {300, 100, 0}, 65536},
};
#define RUNS (int)(sizeof runs / sizeof *runs)

static void plan_mean(Plan *plan)
{
    for (int i = 0; i < RUNS; i++) {
        const Runs *r = &runs[i];
        plan_call(plan, 1, (double[]){r->a[0], r->a[1], r->a[2], r->m, r->b[0], r->b[1], r->b[2], r->n}, 8);
    }
}

static void judge_mean(const Results *results, Finding *finding)
{
    for (int i = 0; i < RUNS; i++) {
        const Runs *r = &runs[i];
        double mean[3], largest = 0.0;
        for (int c = 0; c < 3; c++) {
            mean[c] = (r->m * r->a[c] + r->n * r->b[c]) / (r->m + r->n);
            largest = fmax(largest, fmax(r->a[c], r->b[c]));
        }
        Vec3d expected = vec3d(mean[0], mean[1], mean[2]);
        const float *found = numbers_of(results, (size_t)i, 3, finding);
        char inputs[200];
        snprintf(inputs, sizeof inputs, "a = (%g, %g, %g) over %g passes, b = (%g, %g, %g) over %g", r->a[0], r->a[1],
                 r->a[2], r->m, r->b[0], r->b[1], r->b[2], r->n);
        if (found)
            vector_is(found, expected, 2e-6 * largest, inputs, i, finding);
        for (int c = 0; c < 3; c++)
            finding_feature(finding, found ? ((double)found[c] - mean[c]) / largest : (double)NAN, 0.0);
    }
}

DEFINE_CHECKS(join_means, {"mean", "The mean over all passes", CHECK_VALUES, plan_mean, judge_mean, false})
