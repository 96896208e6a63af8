// Step 3.3: a table of glasses and colours.
#include "judge/checks/step_checks.h"

static const double glasses[][3] = {
    {1.2, 1.5, 2.4}, {1.78133, 1.79132, 1.81369}, {1.5, 1.5, 1.5}, {1.7, 1.4, 1.3}, {1.331, 1.335, 1.343}};
#define KNOWN   5
#define GLASSES 15 // beyond the known ones, others with every salt
#define COLOURS 4
static const char *const names[COLOURS] = {"WHITE", "RED", "GREEN", "BLUE"};

static void glass_of(uint64_t seed, int number, double index[3])
{
    for (int c = 0; c < 3; c++) {
        uint64_t hash = hash_u64(seed + (uint64_t)(3 * number + c));
        index[c] = number < KNOWN ? glasses[number][c] : (double)(float)(1.0 + (double)(hash & 0xfffff) / 1048576.0);
    }
}

static void plan_table(Plan *plan)
{
    for (int g = 0; g < GLASSES; g++) {
        double index[3];
        glass_of(plan->seed, g, index);
        for (int c = 0; c < COLOURS; c++)
            plan_call(plan, 1, (double[]){index[0], index[1], index[2], c}, 4);
    }
}

static void judge_table(const Results *results, Finding *finding)
{
    for (int number = 0; number < GLASSES * COLOURS; number++) {
        double index[3];
        glass_of(results->seed, number / COLOURS, index);
        int colour = number % COLOURS;
        const Numbers *numbers = &results->cases[number];
        double found = numbers->values && numbers->count == 1 ? (double)numbers->values[0] : (double)NAN;
        double expected = colour == WHITE ? (index[0] + index[1] + index[2]) / 3.0 : index[colour - RED];
        if (!(fabs(found - expected) <= 2e-6 * expected))
            finding_fail(finding, number, "expected %.5f%s for %s in glass of indices %g, %g, %g; found %.5f", expected,
                         colour == WHITE ? " (the mean)" : "", names[colour], index[0], index[1], index[2], found);
        finding_ratio(finding, found, expected);
        bool index_at_all = found > 0.1 && found < 20.0; // what lies behind the array may be anything
        if (number < 2 * COLOURS)
            finding_feature(finding, index_at_all ? found - expected : (double)NAN, 0.0);
    }
}

DEFINE_CHECKS(refractive_index,
              {"table", "Each colour's index, and the mean for white", CHECK_VALUES, plan_table, judge_table},
              PICTURE(3))
