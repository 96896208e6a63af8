// Step NUMBER.2: (a + b)/2.
#include "judge/checks/directions.h"

static void plan_values(Plan *plan)
{
    for (int i = 0; i < 8; i++)
        plan_call(plan, 1, (double[]){i, 2}, 2);
}

static void judge_values(const Results *results, Finding *finding)
{
    for (int i = 0; i < 8; i++) {
        const float *found = numbers_of(results, (size_t)i, 1, finding);
        if (found && found[0] != 0.5f * (float)(i + 2))
            finding_fail(finding, i, "for %d and 2: expected %g, found %g", i, 0.5 * (i + 2), (double)found[0]);
        finding_feature(finding, found ? (double)found[0] - 0.5 * (i + 2) : 0.0, 0.0);
    }
}

DEFINE_CHECKS(mean_of_two, {"values", "Means of small numbers", CHECK_VALUES, plan_values, judge_values})
