// Step 2.3: p = P·cosⁿα/I_P before the mirror direction's plane, cosθ_o/π behind it; always true, weight 1.
#include "glossy_cases.h"

static double gap_and_lobe(Vec3d d, const void *input)
{
    const GlossyCase *c = input;
    double height = vec3d_dot(d, c->normal);
    if (height <= 0.0)
        return 0.0;
    if (vec3d_dot(d, c->mirror) <= 0.0)
        return height / (double)PI;
    return 0.5 * (1.0 + c->cos_in) * glossy_lobe(d, c) / c->above;
}

static void judge_density(const Results *results, Finding *finding)
{
    for (int i = 0; i < GLOSSY_CASES; i++) {
        GlossyCase c = glossy_case(i);
        double gap = 0.5 * (1.0 - c.cos_in);
        DirectionCount count;
        DirectionExpectation expected;
        directions_begin(&count, &(DirectionDensity){c.mirror, c.exponent + 1.0, true, gap_and_lobe, &c});
        directions_expect(&count, &expected);
        Sums behind = {0, 0, 0};
        const float *result = numbers_of(results, (size_t)i, GLOSSY_FLOATS * GLOSSY_SAMPLES, finding);
        for (long s = 0; result && s < GLOSSY_SAMPLES; s++, result += GLOSSY_FLOATS) {
            if (result[0] == 0.0f || !direction_is_sound(result + 1, c.inputs, i, finding))
                continue;
            directions_add(&count, result + 1);
            sums_add(&behind, vec3d_dot(vec3d_of(result + 1), c.mirror) <= 0.0);
        }
        finding_p(
            finding, directions_p(&count, &expected), i,
            "expected directions of the density in the contract; for %s a share (1 − cosθ)/2 = %.4f should be diffuse "
            "at 90° or more from the mirror direction, found %.4f, and the mean of cosα be %.4f, found %.4f",
            c.inputs, gap, sums_mean(&behind), expected.along, sums_mean(&count.along));
        directions_features(&count, &expected, finding);
        mean_feature(&behind, gap, finding);
        if (i == 6)
            directions_histogram(&count, &expected, "cosα to the mirror direction, n = 20 at 60°", finding);
    }
}

// Every bounce goes on, with its flux, away from the surface.
static void judge_flux(const Results *results, Finding *finding)
{
    for (int i = 0; i < GLOSSY_CASES; i++) {
        GlossyCase c = glossy_case(i);
        Sums lost = {0, 0, 0}, weight = {0, 0, 0}, below = {0, 0, 0};
        const float *result = numbers_of(results, (size_t)i, GLOSSY_FLOATS * GLOSSY_SAMPLES, finding);
        for (long s = 0; result && s < GLOSSY_SAMPLES; s++, result += GLOSSY_FLOATS) {
            sums_add(&lost, result[0] == 0.0f);
            if (result[0] == 0.0f) {
                finding_fail(finding, i, "expected every photon to go on (true), found false, for %s", c.inputs);
                continue;
            }
            if (!(fabs((double)result[4] - 1.0) < 1e-4))
                finding_fail(finding, i, "expected weight 1, found %g, for %s", (double)result[4], c.inputs);
            direction_is_above(result + 1, c.normal, c.inputs, i, finding);
            sums_add(&weight, (double)result[4]);
            sums_add(&below, vec3d_dot(vec3d_of(result + 1), c.normal) < -1e-4);
        }
        mean_feature(&lost, 0.0, finding);
        mean_feature(&weight, 1.0, finding);
        mean_feature(&below, 0.0, finding);
    }
}

DEFINE_CHECKS(scatter_glossy_source_text,
              {"density", "Directions follow the source text's gap and lobe", CHECK_SAMPLES, plan_glossy, judge_density,
               false},
              {"flux", "Every photon goes on above the surface, weight 1", CHECK_ENERGY, plan_glossy, judge_flux,
               false},
              PICTURE_2_SOURCE)
