// Step 3.3: a table of glasses and colours.
#include "step_checks.h"

#include <math.h>

static const double glasses[][3] = {
    {1.2, 1.5, 2.4}, {1.78133, 1.79132, 1.81369}, {1.5, 1.5, 1.5}, {1.7, 1.4, 1.3}, {1.331, 1.335, 1.343}};
#define GLASSES 5
#define COLOURS 4
static const char *const names[COLOURS] = {"WHITE", "RED", "GREEN", "BLUE"};

static void plan_table(Plan *plan)
{
    for (int g = 0; g < GLASSES; g++)
        for (int c = 0; c < COLOURS; c++)
            plan_call(plan, 1, (double[]){glasses[g][0], glasses[g][1], glasses[g][2], c}, 4);
}

static void judge_table(const Results *results, Finding *finding)
{
    for (int number = 0; number < GLASSES * COLOURS; number++) {
        const double *index = glasses[number / COLOURS];
        int colour = number % COLOURS;
        const Numbers *numbers = &results->cases[number];
        double found = numbers->values && numbers->count == 1 ? (double)numbers->values[0] : (double)NAN;
        double expected = colour == WHITE ? (index[0] + index[1] + index[2]) / 3.0 : index[colour - RED];
        if (!(fabs(found - expected) <= 2e-6 * expected))
            finding_fail(finding, number, "expected %.5f%s for %s in glass of indices %g, %g, %g; found %.5f", expected,
                         colour == WHITE ? " (the mean)" : "", names[colour], index[0], index[1], index[2], found);
        if (number < 2 * COLOURS)
            finding_feature(finding, found - expected, 0.0);
    }
}

DEFINE_CHECKS(refractive_index,
              {"table", "Each colour's index, and the mean for white", CHECK_VALUES, plan_table, judge_table, false},
              PICTURE_3)
