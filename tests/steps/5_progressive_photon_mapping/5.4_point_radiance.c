// Step 5.4: L = τ/(passes · πR²).
#include "judge/checks/directions.h"

#include <stdio.h>

typedef struct {
    double count, radius, flux[3], passes;
} Point;

static const Point points[] = {
    {100, 1, {1, 2, 3}, 1},           {100, 0.1, {0.01, 0.02, 0.03}, 1},
    {7, 0.1, {0.01, 0.02, 0.03}, 10}, {250, 0.004, {1e-4, 2e-5, 0}, 1000},
    {0, 0.5, {0, 0, 0}, 64},          {12, 3, {40, 20, 10}, 7},
};
#define POINTS (int)(sizeof points / sizeof *points)

static void plan_radiance(Plan *plan)
{
    for (int i = 0; i < POINTS; i++) {
        const Point *p = &points[i];
        plan_call(plan, 1, (double[]){p->count, p->radius, p->flux[0], p->flux[1], p->flux[2], p->passes}, 6);
    }
}

static void judge_radiance(const Results *results, Finding *finding)
{
    const double pi = acos(-1.0);
    for (int i = 0; i < POINTS; i++) {
        const Point *p = &points[i];
        double scale = 1.0 / (p->passes * pi * p->radius * p->radius);
        double largest = fmax(p->flux[0], fmax(p->flux[1], p->flux[2])) * scale;
        const float *found = numbers_of(results, (size_t)i, 3, finding);
        char inputs[160];
        snprintf(inputs, sizeof inputs, "N = %g, R = %g m, τ = (%g, %g, %g) after %g passes", p->count, p->radius,
                 p->flux[0], p->flux[1], p->flux[2], p->passes);
        if (found)
            vector_is(found, vec3d(p->flux[0] * scale, p->flux[1] * scale, p->flux[2] * scale), 4e-6 * largest, inputs,
                      i, finding);
        for (int c = 0; c < 3; c++)
            finding_feature(finding,
                            found ? ((double)found[c] - p->flux[c] * scale) / fmax(largest, 1e-9) : (double)NAN, 0.0);
    }
}

DEFINE_CHECKS(point_radiance,
              {"radiance", "Radiance by the statistics", CHECK_VALUES, plan_radiance, judge_radiance, false})
