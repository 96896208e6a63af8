// Step 2.1: density (n+1)/(2π)·cosⁿα about +z.
#include "judge/checks/directions.h"

static const double exponents[] = {0, 1, 5, 20, 100, 1000, 0.5, 2.5, 7.3};
#define EXPONENTS (int)(sizeof exponents / sizeof *exponents)
#define SAMPLES   20000

static const Vec3d up = {0, 0, 1};

static void plan_density(Plan *plan)
{
    for (int i = 0; i < EXPONENTS; i++)
        plan_call(plan, SAMPLES, &exponents[i], 1);
}

static double lobe(Vec3d d, const void *exponent)
{
    return d.z > 0.0 ? pow(d.z, *(const double *)exponent) : 0.0;
}

static void judge_density(const Results *results, Finding *finding)
{
    for (int i = 0; i < EXPONENTS; i++) {
        const char *inputs = words("n = %g", exponents[i]);
        DirectionCount count;
        directions_begin(&count, &(DirectionDensity){up, exponents[i] + 1.0, lobe, &exponents[i]});
        Sums below = {0, 0, 0}, x = {0, 0, 0}, y = {0, 0, 0};
        const float *d = numbers_of(results, (size_t)i, 3 * SAMPLES, finding);
        for (long s = 0; d && s < SAMPLES; s++, d += 3) {
            sums_add(&below, d[2] < -1e-4f);
            sums_add(&x, (double)d[0]);
            sums_add(&y, (double)d[1]);
            if (direction_is_sound(d, inputs, i, finding))
                directions_add(&count, d);
        }
        finding_p(
            finding, directions_p(&count), i,
            "expected directions of density (n+1)/(2π)·cosⁿα about +z; for %s the mean of cosα should be %.4f, found "
            "%.4f, and the means of x and y 0 and 0, found %.4f and %.4f",
            inputs, (exponents[i] + 1.0) / (exponents[i] + 2.0), sums_mean(&count.along), sums_mean(&x), sums_mean(&y));
        directions_features(&count, finding);
        mean_feature(&below, 0.0, finding);
        if (i == 3)
            directions_histogram(&count, "cosα of lobe directions, n = 20", finding);
    }
}

static const double cosine = 1; // the exponent: cos²α is even from 0 to 1

static void plan_azimuth(Plan *plan)
{
    plan_call(plan, FINE_SAMPLES, &cosine, 1);
}

static void judge_azimuth(const Results *results, Finding *finding)
{
    judge_fine(results, "+z", "n = 1", finding);
}

static const double sharp[] = {10000, 1000000};
#define SHARP 2
#define A_FEW 10000

static void plan_sharp(Plan *plan)
{
    for (int i = 0; i < SHARP; i++)
        plan_call(plan, A_FEW, &sharp[i], 1);
}

// Lobes so sharp that a root in float keeps but few digits of sinα: its mean square still comes out. 10 % are ten
// standard errors.
static void judge_sharp(const Results *results, Finding *finding)
{
    for (int i = 0; i < SHARP; i++) {
        const char *inputs = words("n = %g", sharp[i]);
        Sums sine2 = {0, 0, 0};
        const float *d = numbers_of(results, (size_t)i, 3 * A_FEW, finding);
        for (long s = 0; d && s < A_FEW; s++, d += 3) {
            direction_is_sound(d, inputs, i, finding);
            sums_add(&sine2, ((double)d[0] * (double)d[0] + (double)d[1] * (double)d[1]) * (sharp[i] + 3.0) / 2.0);
        }
        double ratio = sums_mean(&sine2);
        if (!(fabs(ratio - 1.0) < 0.1))
            finding_fail(finding, i, "for %s: expected a mean of sin²α of 2/(n+3) = %.3g, found %.3g times that",
                         inputs, 2.0 / (sharp[i] + 3.0), ratio);
        mean_feature(&sine2, 1.0, finding);
    }
}

DEFINE_CHECKS(sample_lobe,
              {"density", "Directions follow the lobe's density", CHECK_SAMPLES, plan_density, judge_density},
              {"azimuth", "Directions spread evenly all around +z", CHECK_SAMPLES, plan_azimuth, judge_azimuth},
              {"sharp", "Very sharp lobes keep their width", CHECK_VALUES, plan_sharp, judge_sharp}, PICTURE(2_phong))
