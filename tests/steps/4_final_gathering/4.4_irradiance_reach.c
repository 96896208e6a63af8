// Step 4.4: the harmonic mean of the distances, within its bounds.
#include "judge/checks/directions.h"

#define CELLS_ALL (GATHER_RINGS * GATHER_SECTORS)

typedef struct {
    const char *what;
    double near, far;  // distances
    double near_share; // of the cells
    double shortest, longest;
} Sight;

static const Sight sights[] = {
    {"2 m in every direction", 2, 2, 1, 0.01, 100},
    {"1 m in one half of the cells, 3 m in the other", 1, 3, 0.5, 0.01, 100},
    {"0.1 m in a tenth of the cells, 10 m in the others", 0.1, 10, 0.1, 0.01, 100},
    {"2 m in one half of the cells, the open in the other", 2, (double)INFINITY, 0.5, 0.01, 100},
    {"0.5 m in a twentieth of the cells, the open in the others", 0.5, (double)INFINITY, 0.05, 0.01, 100},
    {"1 mm in every direction, but at least 0.05 m", 0.001, 0.001, 1, 0.05, 4},
    {"50 m in every direction, but at most 4 m", 50, 50, 1, 0.05, 4},
    {"the open everywhere, but at most 4 m", (double)INFINITY, (double)INFINITY, 0, 0.05, 4},
    {"between 0.2 m and 6 m, different in every cell", 0, 0, 0, 0.01, 100},
    {"between 0.2 m and 6 m, different in every cell again", 0, 0, 0, 0.01, 100},
    {"between 0.2 m and 6 m, different in every cell, but at most 0.3 m", 0, 0, 0, 0.02, 0.3},
};
#define SIGHTS (int)(sizeof sights / sizeof *sights)

// As float. Near and far lie mixed, as the seed has it.
static double distance_of(int sight, int cell, uint64_t seed)
{
    const Sight *s = &sights[sight];
    if (s->near == 0.0)
        return drawn_magnitude(seed, sight * 1000 + cell, 0.2, 6.0);
    int place =
        (cell * 149 + (int)drawn_input(seed, sight, 0.0, CELLS_ALL)) % CELLS_ALL; // 149 has no divisor of their number
    return place < s->near_share * CELLS_ALL ? s->near : s->far;
}

static void plan_reach(Plan *plan)
{
    for (int i = 0; i < SIGHTS; i++) {
        double arguments[CELLS_ALL + 2];
        for (int c = 0; c < CELLS_ALL; c++)
            arguments[c] = distance_of(i, c, plan->seed);
        arguments[CELLS_ALL] = sights[i].shortest;
        arguments[CELLS_ALL + 1] = sights[i].longest;
        plan_call(plan, 1, arguments, CELLS_ALL + 2);
    }
}

// Nothing is near at all: no sum, and the longest.
static double expected_reach(int sight, uint64_t seed)
{
    const Sight *s = &sights[sight];
    double sum = 0.0;
    for (int c = 0; c < CELLS_ALL; c++)
        sum += 1.0 / distance_of(sight, c, seed);
    return fmin(fmax(CELLS_ALL / sum, s->shortest), s->longest);
}

static void judge_reach(const Results *results, Finding *finding)
{
    bool all_right = true; // before the open, of which wrong formulas make anything
    for (int i = 0; i < SIGHTS; i++) {
        double expected = expected_reach(i, results->seed);
        const float *found = numbers_of(results, (size_t)i, 1, finding);
        if (found && all_finite(found, 1, "a reach", sights[i].what, i, finding) &&
            !(fabs((double)*found - expected) <= 1e-3 * expected))
            finding_fail(finding, i, "for distances of %s: expected R = %.4g m, found %.4g m, %.4g times as much",
                         sights[i].what, expected, (double)*found, (double)*found / expected);
        if (expected > sights[i].shortest && expected < sights[i].longest)
            finding_ratio(finding, found ? (double)*found : (double)NAN, expected);
        double off = found ? log(fabs((double)*found) / expected) : (double)NAN;
        finding_feature(finding, sights[i].near_share == 0.0 && isinf(sights[i].near) && !all_right ? 0.0 : off,
                        i < 8 ? 0.0 : 0.05);
        all_right = all_right && fabs(off) < 1e-3;
    }
}

DEFINE_CHECKS(irradiance_reach,
              {"reach", "The harmonic mean of the distances, within its bounds", CHECK_VALUES, plan_reach, judge_reach},
              PICTURE(4))
