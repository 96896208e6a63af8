// Step 2.4: one lobe sample about the mirror direction, absorbed below the surface, weight (n+2)/(n+1)·cosθ_o.
#include "judge/checks/glossy_cases.h"

// Share of lobe samples that lie below the surface.
static double absorbed_share(const GlossyCase *c)
{
    return 1.0 - c->above * (c->exponent + 1.0) / (2.0 * (double)PI);
}

// A sharp lobe lies all above the surface; one in 2²⁴ random numbers may still touch it.
static void judge_absorbed(const GlossyCase *c, const Sums *absorbed, long number, Finding *finding)
{
    double share = absorbed_share(c);
    if (share > 1e-9)
        finding_p(
            finding, binomial_p((long)absorbed->sum, (long)absorbed->count, share), number,
            "expected a share of %.4f to be absorbed (false), as lobe samples below the surface; found %.4f, for %s",
            share, sums_mean(absorbed), c->inputs);
    else if (absorbed->sum > 1.0)
        finding_fail(finding, number, "expected no photon to be absorbed (false), found a share of %.4f, for %s",
                     sums_mean(absorbed), c->inputs);
}

static void judge_density(const Results *results, Finding *finding)
{
    for (int i = 0; i < GLOSSY_CASES; i++) {
        GlossyCase c = glossy_case(i);
        DirectionCount count;
        directions_begin(&count, &(DirectionDensity){c.mirror, c.exponent + 1.0, glossy_lobe, &c});
        Sums absorbed = {0, 0, 0}, below = {0, 0, 0};
        const float *result = numbers_of(results, (size_t)i, PHONG_FLOATS * GLOSSY_SAMPLES, finding);
        for (long s = 0; result && s < GLOSSY_SAMPLES; s++, result += PHONG_FLOATS) {
            sums_add(&absorbed, result[0] == 0.0f);
            if (result[0] == 0.0f || !direction_is_above(result + 1, c.normal, c.inputs, i, finding))
                continue;
            directions_add(&count, result + 1);
            sums_add(&below, vec3d_dot(vec3d_of(result + 1), c.normal) < -1e-4);
        }
        finding_p(
            finding, directions_p(&count), i,
            "expected directions of density cosⁿα about the mirror direction, above the surface; for %s the mean of "
            "cosα should be %.4f, found %.4f",
            c.inputs, count.expected.along, sums_mean(&count.along));
        if (absorbed.count > 0.0)
            judge_absorbed(&c, &absorbed, i, finding);
        directions_features(&count, finding);
        mean_feature(&absorbed, absorbed_share(&c), finding);
        mean_feature(&below, 0.0, finding);
        if (i == 6)
            directions_histogram(&count, "cosα to the mirror direction, n = 20 at 60°", finding);
    }
}

static void judge_weight(const Results *results, Finding *finding)
{
    for (int i = 0; i < GLOSSY_CASES; i++) {
        GlossyCase c = glossy_case(i);
        double factor = (c.exponent + 2.0) / (c.exponent + 1.0);
        Sums off = {0, 0, 0}, ratio = {0, 0, 0};
        const float *result = numbers_of(results, (size_t)i, PHONG_FLOATS * GLOSSY_SAMPLES, finding);
        for (long s = 0; result && s < GLOSSY_SAMPLES; s++, result += PHONG_FLOATS) {
            if (result[0] == 0.0f)
                continue;
            double expected = factor * vec3d_dot(vec3d_of(result + 1), c.normal), weight = (double)result[4];
            if (expected > 0.1)
                finding_ratio(finding, weight, expected);
            sums_add(&off, weight - expected);
            sums_add(&ratio, weight / fmax(expected, 1e-2));
            if (!(fabs(weight - expected) < 2e-4))
                finding_fail(finding, i,
                             "expected weight (n+2)/(n+1)·cosθ_o = %.4f for the direction %s, found %.4f, for %s",
                             expected, text_of_floats(result + 1), weight, c.inputs);
        }
        mean_feature(&off, 0.0, finding);
        mean_feature(&ratio, 1.0, finding);
    }
}

// Weights averaged over all photons, the absorbed counting 0, are the lobe's albedo.
static void judge_albedo(const Results *results, Finding *finding)
{
    for (int i = 0; i < GLOSSY_CASES; i++) {
        GlossyCase c = glossy_case(i);
        double albedo = (c.exponent + 2.0) / (2.0 * (double)PI) * lobe_weighted_exactly(c.exponent, c.cos_in);
        Sums carried = {0, 0, 0};
        const float *result = numbers_of(results, (size_t)i, PHONG_FLOATS * GLOSSY_SAMPLES, finding);
        for (long s = 0; result && s < GLOSSY_SAMPLES; s++, result += PHONG_FLOATS)
            sums_add(&carried, result[0] != 0.0f ? (double)result[4] : 0.0);
        if (result)
            finding_p(finding, normal_p((sums_mean(&carried) - albedo) / sums_error(&carried)), i,
                      "expected a share of %.4f of the flux to be reflected (the lobe's albedo), found %.4f, for %s",
                      albedo, sums_mean(&carried), c.inputs);
        mean_feature(&carried, albedo, finding);
    }
}

DEFINE_CHECKS(scatter_glossy_phong,
              {"density", "Directions follow the lobe, absorbed below the surface", CHECK_SAMPLES, plan_glossy,
               judge_density},
              {"weight", "Each weight is (n+2)/(n+1)·cosθ_o", CHECK_VALUES, plan_glossy, judge_weight},
              {"albedo", "The lobe reflects as much as the modified Phong BRDF", CHECK_ENERGY, plan_glossy,
               judge_albedo},
              PICTURE(2_phong))
