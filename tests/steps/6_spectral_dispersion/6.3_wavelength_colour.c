// Step 6.3: the colour of a wavelength, and that all of them together are white.
#include "judge/checks/directions.h"

#define STEP_NM     5
#define WAVELENGTHS 71 // 380 … 730 nm
#define MORE        20 // by the seed

static double lobe(double wavelength, double middle, double below, double above)
{
    double offset = (wavelength - middle) / (wavelength < middle ? below : above);
    return exp(-0.5 * offset * offset);
}

static void expected_colour(double w, double expected[3])
{
    double x =
        1.056 * lobe(w, 599.8, 37.9, 31.0) + 0.362 * lobe(w, 442.0, 16.0, 26.7) - 0.065 * lobe(w, 501.1, 20.4, 26.2);
    double y = 0.821 * lobe(w, 568.8, 46.9, 40.5) + 0.286 * lobe(w, 530.9, 16.3, 31.1);
    double z = 1.217 * lobe(w, 437.0, 11.8, 36.0) + 0.681 * lobe(w, 459.0, 26.0, 13.8);
    expected[0] = (3.2406 * x - 1.5372 * y - 0.4986 * z) / (double)EQUAL_ENERGY_RED;
    expected[1] = (-0.9689 * x + 1.8758 * y + 0.0415 * z) / (double)EQUAL_ENERGY_GREEN;
    expected[2] = (0.0557 * x - 0.2040 * y + 1.0570 * z) / (double)EQUAL_ENERGY_BLUE;
}

static double wavelength_of(int number, uint64_t seed)
{
    double from_first =
        number < WAVELENGTHS ? STEP_NM * number : (double)(hash_u64(seed + (uint64_t)number) % 3500) / 10.0;
    return (double)(float)((double)WAVELENGTH_FIRST + from_first);
}

static void plan_colours(Plan *plan)
{
    for (int i = 0; i < WAVELENGTHS + MORE; i++)
        plan_call(plan, 1, (double[]){wavelength_of(i, plan->seed)}, 1);
}

static void judge_colours(const Results *results, Finding *finding)
{
    double sum[3] = {0.0, 0.0, 0.0};
    for (int i = 0; i < WAVELENGTHS + MORE; i++) {
        double expected[3], wavelength = wavelength_of(i, results->seed);
        expected_colour(wavelength, expected);
        const float *found = numbers_of(results, (size_t)i, 3, finding);
        const char *inputs = words("light of %.4g nm", wavelength);
        if (found)
            vector_is(found, vec3d(expected[0], expected[1], expected[2]), 2e-4, inputs, i, finding);
        for (int c = 0; i < WAVELENGTHS && c < 3; c++) {
            sum[c] += found ? (double)found[c] * (i == 0 || i == WAVELENGTHS - 1 ? 0.5 : 1.0) : (double)NAN;
            if (i % 5 == 0)
                finding_feature(finding, found ? (double)found[c] - expected[c] : (double)NAN, 0.0);
        }
    }
    for (int c = 0; c < 3; c++)
        finding_feature(finding, sum[c] / (WAVELENGTHS - 1) - 1.0, 0.0);
}

DEFINE_CHECKS(wavelength_colour, {"colours", "The colours of the spectrum", CHECK_VALUES, plan_colours, judge_colours},
              PICTURE(6))
