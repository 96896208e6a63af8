// Step 6.2: by inversion of a density like 1/cosh², and what a wavelength then counts.
#include "judge/checks/directions.h"

#define DRAWS_EVEN 24 // from 0 on; more by the seed
#define DRAWS_ALL  40

static double drawn_share(uint64_t seed, int number)
{
    return number < DRAWS_EVEN ? (double)number / DRAWS_EVEN
                               : (double)(hash_u64(seed ^ hash_u64((uint64_t)number)) >> 40) * 0x1p-24;
}

static void plan_draws(Plan *plan)
{
    for (int i = 0; i < DRAWS_ALL; i++)
        plan_call(plan, 1, (double[]){drawn_share(plan->seed, i)}, 1);
}

static double tangent(double wavelength)
{
    return tanh((wavelength - (double)WAVELENGTH_MIDDLE) / (double)WAVELENGTH_SPREAD);
}

static void judge_draws(const Results *results, Finding *finding)
{
    double first = tangent((double)WAVELENGTH_FIRST), last = tangent((double)WAVELENGTH_LAST);
    for (int i = 0; i < DRAWS_ALL; i++) {
        double u = drawn_share(results->seed, i), t = first + u * (last - first);
        double wavelength = (double)WAVELENGTH_MIDDLE + (double)WAVELENGTH_SPREAD * atanh(t);
        double weight = (double)WAVELENGTH_SPREAD * (last - first) / (1.0 - t * t) / (double)WAVELENGTH_RANGE;
        const float *found = numbers_of(results, (size_t)i, 2, finding);
        const char *inputs = words("u = %.4g", u);
        bool sound = found && all_finite(found, 2, "wavelength and weight", inputs, i, finding);
        if (sound && !(fabs((double)found[0] - wavelength) <= 0.01))
            finding_fail(finding, i, "for %s: expected %.2f nm, found %.2f", inputs, wavelength, (double)found[0]);
        if (sound && !(fabs((double)found[1] - weight) <= 1e-4 * weight))
            finding_fail(finding, i, "for %s: expected the weight %.4f, found %.4f", inputs, weight, (double)found[1]);
        if (i >= DRAWS_EVEN)
            continue; // the others follow the salt
        finding_feature(finding, found ? ((double)found[0] - wavelength) / (double)WAVELENGTH_RANGE : (double)NAN, 0.0);
        finding_feature(finding, found ? log(fabs((double)found[1]) / weight) : (double)NAN, 0.0);
        finding_ratio(finding, found && fabs((double)found[0] - wavelength) <= 0.01 ? (double)found[1] : (double)NAN,
                      weight);
    }
}

DEFINE_CHECKS(draw_wavelength, {"draws", "Wavelengths and weights over u", CHECK_VALUES, plan_draws, judge_draws},
              PICTURE(6))
