// Step 5.3: N' = N + αM, R'² = R²·(N + αM)/(N + M), τ' = (τ + Φ)·R'²/R².
#include "judge/checks/directions.h"

typedef struct {
    double count, radius, before[3]; // N, R, τ
    double found, flux[3], alpha;    // M, Φ, α
} Pass;

static const Pass known[] = {
    {0, 0.1, {0, 0, 0}, 8, {4, 2, 1}, 0.5},
    {4, 0.1, {4, 2, 1}, 8, {4, 2, 1}, 0.5},
    {10, 0.05, {1, 1, 1}, 5, {0.25, 0.5, 0.75}, 2.0 / 3.0},
    {400.5, 0.02, {3, 2, 1}, 7, {0.01, 0.02, 0.03}, 2.0 / 3.0},
    {10, 0.05, {1, 2, 3}, 0, {0, 0, 0}, 0.6},
    {0, 0.3, {0, 0, 0}, 0, {0, 0, 0}, 0.6},
    {20, 2, {0.5, 0.25, 0.125}, 60, {0, 1, 0}, 0.25},
    {6, 1, {2, 3, 4}, 6, {1, 0, 2}, 1},
    {2.5, 0.1, {1, 2, 3}, 1, {0.5, 0.25, 1}, 0.7},
    {3e6, 0.1, {9, 6, 3}, 1000000, {3, 2, 1}, 0.5},
};
#define KNOWN   (int)(sizeof known / sizeof *known)
#define PASSES  (KNOWN + 15) // beyond the known ones, others with every salt
#define CALLS   2
#define NUMBERS 5

// Among them a first pass, one that finds nothing and one that finds a single photon.
static Pass pass_of(int i, uint64_t seed)
{
    if (i < KNOWN)
        return known[i];
    int use = 20 * i;
    Pass p = {.radius = drawn_magnitude(seed, use, 1e-3, 5.0),
              .found = i % 5 == 1   ? 0.0
                       : i % 5 == 2 ? 1.0
                                    : floor(drawn_magnitude(seed, use + 1, 2.01, 3e4)),
              .alpha = drawn_input(seed, use + 2, 0.05, 0.95)};
    if (i % 5 != 0)
        p.count = drawn_magnitude(seed, use + 3, 0.5, 3e4);
    for (int c = 0; c < 3; c++) {
        p.before[c] = p.count > 0.0 ? drawn_magnitude(seed, use + 4 + c, 1e-3, 10.0) : 0.0;
        p.flux[c] = p.found > 0.0 ? drawn_magnitude(seed, use + 7 + c, 1e-3, 10.0) : 0.0;
    }
    return p;
}

static void plan_statistics(Plan *plan)
{
    for (int i = 0; i < PASSES; i++) {
        Pass p = pass_of(i, plan->seed);
        plan_call(plan, CALLS,
                  (double[]){p.count, p.radius, p.before[0], p.before[1], p.before[2], p.found, p.flux[0], p.flux[1],
                             p.flux[2], p.alpha},
                  10);
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

static double scale_of(double expected)
{
    return expected > 0.0 ? expected : 1.0;
}

static void judge_point(const float *found, const double expected[NUMBERS], const char *inputs, int number,
                        Finding *finding)
{
    static const char *const names[NUMBERS] = {"N'", "R'", "red of τ'", "green of τ'", "blue of τ'"};
    if (!all_finite(found, NUMBERS, "a point's statistics", inputs, number, finding))
        return;
    for (int n = 0; n < NUMBERS; n++)
        if (!(fabs((double)found[n] - expected[n]) <= 4e-6 * scale_of(expected[n])))
            finding_fail(finding, number, "for %s: expected %s = %.7g, found %.7g", inputs, names[n], expected[n],
                         (double)found[n]);
}

static void judge_statistics(const Results *results, Finding *finding)
{
    for (int i = 0; i < PASSES; i++) {
        Pass p = pass_of(i, results->seed);
        double expected[NUMBERS];
        expect(&p, expected);
        const float *found = numbers_of(results, (size_t)i, CALLS * NUMBERS, finding);
        const char *inputs =
            words("N = %.7g, R = %.7g m, τ = (%.5g, %.5g, %.5g), M = %.0f, Φ = (%.5g, %.5g, %.5g), α = %.5g", p.count,
                  p.radius, p.before[0], p.before[1], p.before[2], p.found, p.flux[0], p.flux[1], p.flux[2], p.alpha);
        for (int call = 0; found && call < CALLS; call++)
            judge_point(found + call * NUMBERS, expected, inputs, i, finding);
        for (int n = 0; i < KNOWN && n < NUMBERS; n++)
            finding_feature(finding, found ? ((double)found[n] - expected[n]) / scale_of(expected[n]) : (double)NAN,
                            0.0);
    }
}

DEFINE_CHECKS(add_photons,
              {"statistics", "Count, radius and flux after a pass", CHECK_VALUES, plan_statistics, judge_statistics},
              PICTURE(5_pixel))
