// Step 5.1: r_{i+1} = r_i √((i + α)/(i + 1)).
#include "judge/checks/directions.h"

#include <stdio.h>

typedef struct {
    double radius, pass, alpha;
} Pass;

static const Pass passes[] = {
    {1, 1, 0.5},      {1, 2, 0.5},     {0.05, 1, 2.0 / 3.0}, {0.05, 7, 2.0 / 3.0}, {0.05, 1000, 2.0 / 3.0},
    {2.5, 3, 0.25},   {2.5, 30, 0.25}, {0.004, 1, 0.9},      {0.004, 12, 0.9},     {0.2, 5, 1},
    {0.2, 50000, 0.1}};
#define PASSES (int)(sizeof passes / sizeof *passes)

static void plan_radius(Plan *plan)
{
    for (int i = 0; i < PASSES; i++)
        plan_call(plan, 1, (double[]){passes[i].radius, passes[i].pass, passes[i].alpha}, 3);
}

static void judge_radius(const Results *results, Finding *finding)
{
    for (int i = 0; i < PASSES; i++) {
        const Pass *p = &passes[i];
        double expected = p->radius * sqrt((p->pass + p->alpha) / (p->pass + 1.0));
        const float *found = numbers_of(results, (size_t)i, 1, finding);
        char inputs[100];
        snprintf(inputs, sizeof inputs, "r = %.4g m in pass %g, α = %.4g", p->radius, p->pass, p->alpha);
        if (found && all_finite(found, 1, "a radius", inputs, i, finding) &&
            !(fabs((double)*found - expected) <= 2e-6 * expected))
            finding_fail(finding, i, "for %s: expected a next radius of %.7g m, found %.7g m", inputs, expected,
                         (double)*found);
        finding_feature(finding, found ? (double)*found / expected - 1.0 : (double)NAN, 0.0);
    }
}

DEFINE_CHECKS(next_radius, {"radius", "The radius of the next pass", CHECK_VALUES, plan_radius, judge_radius, false})
