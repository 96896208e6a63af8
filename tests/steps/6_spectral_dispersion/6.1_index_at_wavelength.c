// Step 6.1: Sellmeier's formula for real glass, Cauchy's for other.
#include "judge/checks/directions.h"

// Two of Cauchy's form before the catalogue's.
static const double cauchy[][2] = {{1.5046, 0.0042}, {1.74, 0.018}};
#define CAUCHY      2
#define GLASSES     8
#define ALWAYS      6 // wavelengths
#define WAVELENGTHS 8 // two more by the seed
static const double wavelengths[ALWAYS] = {380, 441.6, 500, 546.1, 632.8, 730};

static double wavelength_of(int number, uint64_t seed)
{
    return number % WAVELENGTHS < ALWAYS ? wavelengths[number % WAVELENGTHS]
                                         : 380.0 + (double)(hash_u64(seed + (uint64_t)number) % 3500) / 10.0;
}

static const SellmeierGlass *glass_of(int number)
{
    return number < CAUCHY ? NULL : glass_at((size_t)(number - CAUCHY));
}

static double expected_index(int number, double wavelength)
{
    return number < CAUCHY ? cauchy[number][0] + cauchy[number][1] * 1e6 / (wavelength * wavelength)
                           : glass_index(glass_of(number), wavelength);
}

static void plan_index(Plan *plan)
{
    for (int i = 0; i < GLASSES * WAVELENGTHS; i++) {
        double arguments[3 + 2 * SELLMEIER_TERMS] = {0};
        const SellmeierGlass *glass = glass_of(i / WAVELENGTHS);
        for (int c = 0; c < 2 && !glass; c++)
            arguments[c] = cauchy[i / WAVELENGTHS][c];
        for (int t = 0; t < SELLMEIER_TERMS && glass; t++) {
            arguments[2 + t] = glass->b[t];
            arguments[2 + SELLMEIER_TERMS + t] = glass->c[t];
        }
        arguments[2 + 2 * SELLMEIER_TERMS] = wavelength_of(i, plan->seed);
        plan_call(plan, 1, arguments, 3 + 2 * SELLMEIER_TERMS);
    }
}

static void judge_index(const Results *results, Finding *finding)
{
    for (int i = 0; i < GLASSES * WAVELENGTHS; i++) {
        const SellmeierGlass *glass = glass_of(i / WAVELENGTHS);
        double wavelength = wavelength_of(i, results->seed), expected = expected_index(i / WAVELENGTHS, wavelength);
        const float *found = numbers_of(results, (size_t)i, 1, finding);
        const char *inputs = words("%s at %.4g nm", glass ? glass->name : "glass of Cauchy's form", wavelength);
        if (found && all_finite(found, 1, "an index", inputs, i, finding) &&
            !(fabs((double)*found - expected) <= 1e-5 * expected))
            finding_fail(finding, i, "for %s: expected the index %.6f, found %.6f", inputs, expected, (double)*found);
        finding_ratio(finding, found ? (double)*found : (double)NAN, expected);
        if (i % WAVELENGTHS < ALWAYS)
            finding_feature(finding, found ? (double)*found / expected - 1.0 : (double)NAN, 0.0);
    }
}

DEFINE_CHECKS(index_at_wavelength, {"index", "Real glasses and made-up ones", CHECK_VALUES, plan_index, judge_index},
              PICTURE(6))
