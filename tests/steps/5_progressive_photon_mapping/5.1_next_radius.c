// Step 5.1: r_{i+1} = r_i √((i + α)/(i + 1)).
#include "judge/checks/directions.h"

typedef struct {
    double radius, pass, alpha;
} Pass;

static const Pass known[] = {
    {1, 1, 0.5},      {1, 2, 0.5},     {0.05, 1, 2.0 / 3.0}, {0.05, 7, 2.0 / 3.0}, {0.05, 1000, 2.0 / 3.0},
    {2.5, 3, 0.25},   {2.5, 30, 0.25}, {0.004, 1, 0.9},      {0.004, 12, 0.9},     {0.2, 5, 1},
    {0.2, 50000, 0.1}};
#define KNOWN  (int)(sizeof known / sizeof *known)
#define PASSES (KNOWN + 15) // beyond the known ones, others with every salt
#define CALLS  2

static Pass pass_of(int i, uint64_t seed)
{
    if (i < KNOWN)
        return known[i];
    double most = i % 3 == 0 ? 1e6 : i % 3 == 1 ? 1000.0 : 8.0;
    return (Pass){.radius = drawn_magnitude(seed, 10 * i, 1e-3, 10.0),
                  .pass = floor(drawn_magnitude(seed, 10 * i + 1, 1.01, most)),
                  .alpha = drawn_input(seed, 10 * i + 2, 0.05, 0.95)};
}

static void plan_radius(Plan *plan)
{
    for (int i = 0; i < PASSES; i++) {
        Pass p = pass_of(i, plan->seed);
        plan_call(plan, CALLS, (double[]){p.radius, p.pass, p.alpha}, 3);
    }
}

static void judge_radius(const Results *results, Finding *finding)
{
    for (int i = 0; i < PASSES; i++) {
        Pass p = pass_of(i, results->seed);
        double expected = p.radius * sqrt((p.pass + p.alpha) / (p.pass + 1.0));
        const float *found = numbers_of(results, (size_t)i, CALLS, finding);
        const char *inputs = words("r = %.7g m in pass %.0f, α = %.7g", p.radius, p.pass, p.alpha);
        bool sound = found && all_finite(found, CALLS, "a radius", inputs, i, finding);
        for (int call = 0; sound && call < CALLS; call++)
            if (!(fabs((double)found[call] - expected) <= 4e-6 * expected)) // room for logarithms in float
                finding_fail(finding, i, "for %s: expected a next radius of %.7g m, found %.7g m", inputs, expected,
                             (double)found[call]);
        if (i < KNOWN)
            finding_feature(finding, found ? (double)*found / expected - 1.0 : (double)NAN, 0.0);
    }
}

DEFINE_CHECKS(next_radius, {"radius", "The radius of the next pass", CHECK_VALUES, plan_radius, judge_radius},
              PICTURE_AND_V(5_pass))
