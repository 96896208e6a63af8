// Step 2.3: p = P·cosⁿα/I_P before the mirror direction's plane, cosθ_o/π behind it; always true, weight 1.
#include "judge/checks/glossy_cases.h"

#include <stdio.h>

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
        directions_begin(&count, &(DirectionDensity){c.mirror, c.exponent + 1.0, gap_and_lobe, &c});
        Sums behind = {0, 0, 0};
        const float *result = numbers_of(results, (size_t)i, SOURCE_FLOATS * GLOSSY_SAMPLES, finding);
        for (long s = 0; result && s < GLOSSY_SAMPLES; s++, result += SOURCE_FLOATS) {
            if (result[0] == 0.0f || !direction_is_sound(result + 1, c.inputs, i, finding))
                continue;
            directions_add(&count, result + 1);
            sums_add(&behind, vec3d_dot(vec3d_of(result + 1), c.mirror) <= 0.0);
        }
        finding_p(
            finding, directions_p(&count), i,
            "expected directions of the density in the contract; for %s a share (1 − cosθ)/2 = %.4f should be diffuse "
            "at 90° or more from the mirror direction, found %.4f, and the mean of cosα be %.4f, found %.4f",
            c.inputs, gap, sums_mean(&behind), count.expected.along, sums_mean(&count.along));
        directions_features(&count, finding);
        mean_feature(&behind, gap, finding);
        if (i == 6)
            directions_histogram(&count, "cosα to the mirror direction, n = 20 at 60°", finding);
    }
}

// Every bounce goes on, with its flux, away from the surface.
static void judge_flux(const Results *results, Finding *finding)
{
    for (int i = 0; i < GLOSSY_CASES; i++) {
        GlossyCase c = glossy_case(i);
        Sums lost = {0, 0, 0}, weight = {0, 0, 0}, below = {0, 0, 0};
        const float *result = numbers_of(results, (size_t)i, SOURCE_FLOATS * GLOSSY_SAMPLES, finding);
        for (long s = 0; result && s < GLOSSY_SAMPLES; s++, result += SOURCE_FLOATS) {
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

// A normal that leans away from the photon, as on a mesh: the mirror direction lies below the surface.
//   far    no lobe sample is ever above it: all that turn to the lobe must give up
//   near   about 1 in 100 is: after 1000 redraws, e^−10 of them give up; after 300, e^−3
static const struct {
    const char *what;
    double degrees; // of the mirror direction below the surface; the lobe is 0.6° wide
    long calls;
} leaning[] = {{"5°, where no lobe sample is above it", 5.0, 200},
               {"1.33°, where 1 lobe sample in 100 is above it", 1.33, 3000}};
#define LEANING       2
#define LEANING_N     10000.0
#define MOST_GIVEN_UP 5 // of "near": 0.07 are expected

static GlossyCase leaning_case(int i)
{
    GlossyCase c = {.exponent = LEANING_N, .normal = {0, 0, 1}};
    c.direction = vec3d_rounded(direction_at(c.normal, 90.0 - leaning[i].degrees, 40.0));
    c.cos_in = -vec3d_dot(c.direction, c.normal);
    c.mirror = vec3d_unit(mirrored(c.direction, c.normal));
    snprintf(c.inputs, sizeof c.inputs, "n = %g and a mirror direction below the surface by %s", LEANING_N,
             leaning[i].what);
    return c;
}

static void plan_cap(Plan *plan)
{
    for (int i = 0; i < LEANING; i++) {
        GlossyCase c = leaning_case(i);
        double arguments[] = {c.direction.x, c.direction.y, c.direction.z, c.normal.x,
                              c.normal.y,    c.normal.z,    c.exponent};
        plan_call(plan, leaning[i].calls, arguments, 7);
    }
}

// One call: whether it gave up, and said so.
static void judge_call(const GlossyCase *c, int i, const float *result, Finding *finding)
{
    bool gave_up = result[0] == 0.0f;
    if (result[5] != (gave_up ? 1.0f : 0.0f))
        finding_fail(finding, i,
                     "expected it to give up after 1000 redraws (MAX_LOBE_TRIES): call redraw_cap_reached() once and "
                     "return false; found %s with %g calls of it, for %s",
                     gave_up ? "false" : "true", (double)result[5], c->inputs);
    if (gave_up || !direction_is_above(result + 1, c->normal, c->inputs, i, finding))
        return;
    if (i == 0 && vec3d_dot(vec3d_of(result + 1), c->mirror) > 1e-4)
        finding_fail(finding, i,
                     "expected it to give up after 1000 redraws (MAX_LOBE_TRIES), call redraw_cap_reached() and return "
                     "false; found true and the direction %s, which is no lobe sample, for %s",
                     text_of_floats(result + 1), c->inputs);
}

static void judge_cap(const Results *results, Finding *finding)
{
    for (int i = 0; i < LEANING; i++) {
        GlossyCase c = leaning_case(i);
        long calls = leaning[i].calls;
        double share = i == 0 ? 0.5 * (1.0 + c.cos_in) : 0.0; // diffuse draws on the mirror direction's side
        Sums gave_up = {0, 0, 0}, said = {0, 0, 0};
        const float *result = numbers_of(results, (size_t)i, SOURCE_FLOATS * (size_t)calls, finding);
        for (long s = 0; result && s < calls; s++, result += SOURCE_FLOATS) {
            judge_call(&c, i, result, finding);
            sums_add(&gave_up, result[0] == 0.0f);
            sums_add(&said, (double)result[5]);
        }
        if (result && share > 0.0)
            finding_p(finding, binomial_p((long)gave_up.sum, calls, share), i,
                      "expected a share of %.3f to give up after 1000 redraws (MAX_LOBE_TRIES), call "
                      "redraw_cap_reached() and return false; found %.3f, for %s",
                      share, sums_mean(&gave_up), c.inputs);
        if (result && share <= 0.0 && gave_up.sum > MOST_GIVEN_UP)
            finding_fail(finding, i,
                         "expected it to give up after 1000 redraws (MAX_LOBE_TRIES), not before: next to never, for "
                         "%s; found that %.0f calls of %ld returned false",
                         c.inputs, gave_up.sum, calls);
        mean_feature(&gave_up, share, finding);
        mean_feature(&said, share, finding);
    }
}

DEFINE_CHECKS(scatter_glossy_source_text,
              {"density", "Directions follow the source text's gap and lobe", CHECK_SAMPLES, plan_glossy,
               judge_density},
              {"flux", "Every photon goes on above the surface, weight 1", CHECK_ENERGY, plan_glossy, judge_flux},
              {"cap", "It gives up after 1000 redraws, and says so", CHECK_SAMPLES, plan_cap, judge_cap},
              PICTURE(2_source))
