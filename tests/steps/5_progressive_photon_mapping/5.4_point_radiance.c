// Step 5.4: L = τ/(passes · πR²).
#include "judge/checks/directions.h"

typedef struct {
    double count, radius, flux[3], passes;
} Point;

static const Point known[] = {
    {100, 1, {1, 2, 3}, 1},           {100, 0.1, {0.01, 0.02, 0.03}, 1},
    {7, 0.1, {0.01, 0.02, 0.03}, 10}, {250, 0.004, {1e-4, 2e-5, 0}, 1000},
    {0, 0.5, {0, 0, 0}, 64},          {12, 3, {40, 20, 10}, 7},
    {0.6, 0.2, {0.5, 0.1, 0.3}, 2},   {3e6, 1e-4, {1e-7, 3e-7, 2e-7}, 1000000},
};
#define KNOWN  (int)(sizeof known / sizeof *known)
#define POINTS (KNOWN + 12) // beyond the known ones, others with every salt
#define CALLS  2

static Point point_of(int i, uint64_t seed)
{
    if (i < KNOWN)
        return known[i];
    Point p = {.count = drawn_magnitude(seed, 20 * i, 0.5, 1e5),
               .radius = drawn_magnitude(seed, 20 * i + 1, 1e-3, 5.0),
               .passes = i % 4 == 0 ? 1.0 : floor(drawn_magnitude(seed, 20 * i + 2, 2.01, i % 4 == 1 ? 1e6 : 100.0))};
    for (int c = 0; c < 3; c++)
        p.flux[c] = (double)(float)(p.passes * drawn_magnitude(seed, 20 * i + 3 + c, 1e-3, 10.0));
    return p;
}

static void plan_radiance(Plan *plan)
{
    for (int i = 0; i < POINTS; i++) {
        Point p = point_of(i, plan->seed);
        plan_call(plan, CALLS, (double[]){p.count, p.radius, p.flux[0], p.flux[1], p.flux[2], p.passes}, 6);
    }
}

static void judge_radiance(const Results *results, Finding *finding)
{
    const double pi = acos(-1.0);
    for (int i = 0; i < POINTS; i++) {
        Point p = point_of(i, results->seed);
        double scale = 1.0 / (p.passes * pi * p.radius * p.radius);
        double largest = fmax(p.flux[0], fmax(p.flux[1], p.flux[2])) * scale;
        const float *found = numbers_of(results, (size_t)i, 3 * CALLS, finding);
        const char *inputs = words("N = %.5g, R = %.7g m, τ = (%.5g, %.5g, %.5g) after %.0f passes", p.count, p.radius,
                                   p.flux[0], p.flux[1], p.flux[2], p.passes);
        for (int call = 0; found && call < CALLS; call++)
            vector_is(found + 3 * call, vec3d(p.flux[0] * scale, p.flux[1] * scale, p.flux[2] * scale), 4e-6 * largest,
                      inputs, i, finding);
        for (int c = 0; i < KNOWN && c < 3; c++)
            finding_feature(finding,
                            found && p.flux[c] > 0.0 ? log(fabs((double)found[c]) / (p.flux[c] * scale))
                            : found                  ? (double)found[c]
                                                     : (double)NAN,
                            0.0);
    }
}

DEFINE_CHECKS(point_radiance, {"radiance", "Radiance by the statistics", CHECK_VALUES, plan_radiance, judge_radiance},
              PICTURE(5_pixel))
