// Step 5.3: N' = N + αM, R'² = R²·(N + αM)/(N + M), τ' = (τ + Φ)·R'²/R².
#include "judge/checks/directions.h"

#include <stdio.h>

typedef struct {
    double count, radius, before[3]; // N, R, τ
    double found, flux[3], alpha;    // M, Φ, α
} Pass;

static const Pass passes[] = {
    {0, 0.1, {0, 0, 0}, 8, {4, 2, 1}, 0.5},
    {4, 0.1, {4, 2, 1}, 8, {4, 2, 1}, 0.5},
    {10, 0.05, {1, 1, 1}, 5, {0.25, 0.5, 0.75}, 2.0 / 3.0},
    {400.5, 0.02, {3, 2, 1}, 7, {0.01, 0.02, 0.03}, 2.0 / 3.0},
    {10, 0.05, {1, 2, 3}, 0, {0, 0, 0}, 0.6},
    {0, 0.3, {0, 0, 0}, 0, {0, 0, 0}, 0.6},
    {20, 2, {0.5, 0.25, 0.125}, 60, {0, 1, 0}, 0.25},
    {6, 1, {2, 3, 4}, 6, {1, 0, 2}, 1},
};
#define PASSES  (int)(sizeof passes / sizeof *passes)
#define NUMBERS 5

static void plan_statistics(Plan *plan)
{
    for (int i = 0; i < PASSES; i++) {
        const Pass *p = &passes[i];
        const double arguments[] = {p->count, p->radius,  p->before[0], p->before[1], p->before[2],
                                    p->found, p->flux[0], p->flux[1],   p->flux[2],   p->alpha};
        plan_call(plan, 1, arguments, 10);
    }
}

static void expect(const Pass *p, double expected[NUMBERS])
{
    double kept = p->count + p->alpha * p->found, all = p->count + p->found;
    double share = all > 0.0 ? kept / all : 1.0;
    expected[0] = kept;
    expected[1] = p->radius * sqrt(share);
    for (int c = 0; c < 3; c++)
        expected[2 + c] = (p->before[c] + p->flux[c]) * share;
}

static void judge_statistics(const Results *results, Finding *finding)
{
    static const char *const names[NUMBERS] = {"N'", "R'", "red of τ'", "green of τ'", "blue of τ'"};
    for (int i = 0; i < PASSES; i++) {
        const Pass *p = &passes[i];
        double expected[NUMBERS];
        expect(p, expected);
        const float *found = numbers_of(results, (size_t)i, NUMBERS, finding);
        char inputs[240];
        snprintf(inputs, sizeof inputs, "N = %g, R = %g m, τ = (%g, %g, %g), M = %g, Φ = (%g, %g, %g), α = %.4g",
                 p->count, p->radius, p->before[0], p->before[1], p->before[2], p->found, p->flux[0], p->flux[1],
                 p->flux[2], p->alpha);
        bool sound = found && all_finite(found, NUMBERS, "a point's statistics", inputs, i, finding);
        for (int n = 0; n < NUMBERS; n++) {
            double scale = expected[n] > 0.0 ? expected[n] : 1.0;
            if (sound && !(fabs((double)found[n] - expected[n]) <= 4e-6 * scale))
                finding_fail(finding, i, "for %s: expected %s = %.7g, found %.7g", inputs, names[n], expected[n],
                             (double)found[n]);
            finding_feature(finding, found ? ((double)found[n] - expected[n]) / scale : (double)NAN, 0.0);
        }
    }
}

DEFINE_CHECKS(add_photons, {"statistics", "Count, radius and flux after a pass", CHECK_VALUES, plan_statistics,
                            judge_statistics, false})
