// Step NUMBER.1: v/2.
#include "judge/checks/directions.h"

static void plan_values(Plan *plan)
{
    for (int i = 0; i < 8; i++)
        plan_call(plan, 1, (double[]){i}, 1);
}

static void judge_values(const Results *results, Finding *finding)
{
    for (int i = 0; i < 8; i++) {
        const float *found = numbers_of(results, (size_t)i, 1, finding);
        if (found && found[0] != 0.5f * (float)i)
            finding_fail(finding, i, "for %d: expected %g, found %g", i, 0.5 * i, (double)found[0]);
        finding_feature(finding, found ? (double)found[0] - 0.5 * i : 0.0, 0.0);
    }
}

DEFINE_CHECKS(halve, {"values", "Halves of small numbers", CHECK_VALUES, plan_values, judge_values})
