// Step 3.2: Fresnel reflectance, in double precision, over a table of indices and angles.
#include "judge/checks/path_batches.h"

static const double etas[] = {1.0 / 2.42, 1.0 / 1.5, 1.0 / 1.33, 1.0, 1.33, 1.5, 2.42};
#define ETAS 7
// cosθ_i. Among them cos of 24° and 24.8°, and of 41.5° and 42.2°: below and above the critical angles of 2.42 and 1.5.
static const double cosines[] = {1.0,          0.99, 0.9135454576, 0.9077775, 0.8,  0.74895572, 0.74080456, 0.6,
                                 0.5547001962, 0.4,  0.2,          0.1,       0.03, 0.01,       0.001,      1e-5};
#define COSINES   16
#define TOLERANCE 1e-3
#define ROUNDING  1e-5 // of cos²θ_t in float, many times over: below it only the range is asked for

#define ANYWHERE 60

// One of other pairs with every salt: cosθ_i and eta.
static void pair_of(uint64_t seed, int number, double *cos_i, double *eta)
{
    uint64_t hash = hash_u64(seed + (uint64_t)number);
    *cos_i = (double)(float)(0.02 + 0.98 * (double)(hash & 0xfffff) / 1048576.0);
    *eta = (double)(float)(0.4 + 2.1 * (double)(hash >> 20 & 0xfffff) / 1048576.0);
}

static void plan_table(Plan *plan)
{
    for (int e = 0; e < ETAS; e++)
        for (int i = 0; i < COSINES; i++)
            plan_call(plan, 1, (double[]){(double)(float)cosines[i], (double)(float)etas[e]}, 2);
}

static double found_in(const Numbers *numbers)
{
    return numbers->values && numbers->count == 1 ? (double)numbers->values[0] : (double)NAN;
}

// Named cases first: the sentence says which law is broken.
static void judge_value(double cos_i, double eta, double found, long number, Finding *finding)
{
    double expected = exact_fresnel(cos_i, eta);
    double cos2_t = 1.0 - eta * eta * (1.0 - cos_i * cos_i);
    bool near = fabs(cos2_t) < ROUNDING || fabs(found - expected) <= TOLERANCE;
    if (near && found >= -1e-6 && found <= 1.0 + 1e-6)
        return;
    if (isnan(found))
        finding_fail(finding, number, "expected %.4f for cosθ_i = %g, eta = %.4g; found something that is not a number",
                     expected, cos_i, eta);
    else if (found < -1e-6 || found > 1.0 + 1e-6)
        finding_fail(finding, number, "expected a share from 0 to 1; found %.4f for cosθ_i = %g, eta = %.4g", found,
                     cos_i, eta);
    else if (eta == 1.0)
        finding_fail(finding, number, "expected no reflection between equal indices; found %.4f for cosθ_i = %g", found,
                     cos_i);
    else if (cos2_t < 0.0)
        finding_fail(finding, number, "expected 1 under total reflection (cosθ_i = %g, eta = %.4g); found %.4f", cos_i,
                     eta, found);
    else if (cos_i == 1.0)
        finding_fail(finding, number, "expected ((n-1)/(n+1))² = %.4f straight on, for eta = %.4g; found %.4f",
                     expected, eta, found);
    else
        finding_fail(finding, number, "expected (r_s² + r_p²)/2 = %.4f for cosθ_i = %.4g, eta = %.4g; found %.4f",
                     expected, cos_i, eta, found);
}

static void judge_table(const Results *results, Finding *finding)
{
    for (int number = 0; number < ETAS * COSINES; number++) {
        double cos_i = (double)(float)cosines[number % COSINES], eta = (double)(float)etas[number / COSINES];
        double found = found_in(&results->cases[number]);
        judge_value(cos_i, eta, found, number, finding);
        if (number % COSINES % 3 == 0 && number % COSINES < 15) // 1, 0.91, 0.74, 0.4, …
            finding_feature(finding, found - exact_fresnel(cos_i, eta), 0.0);
    }
}

static void plan_anywhere(Plan *plan)
{
    for (int number = 0; number < ANYWHERE; number++) {
        double arguments[2];
        pair_of(plan->seed, number, &arguments[0], &arguments[1]);
        plan_call(plan, 1, arguments, 2);
    }
}

static void judge_anywhere(const Results *results, Finding *finding)
{
    for (int number = 0; number < ANYWHERE; number++) {
        double cos_i, eta;
        pair_of(results->seed, number, &cos_i, &eta);
        judge_value(cos_i, eta, found_in(&results->cases[number]), number, finding);
    }
}

DEFINE_CHECKS(fresnel, {"table", "The share reflected, over indices and angles", CHECK_VALUES, plan_table, judge_table},
              {"anywhere", "The share reflected, for any index and angle", CHECK_VALUES, plan_anywhere, judge_anywhere},
              PICTURE(3))
