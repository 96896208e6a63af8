// Step 1.4: a share p = min(1, ΣΦρ/ΣΦ) survives, with power Φρ/p.
#include "judge/checks/directions.h"

typedef struct {
    Vec3d power, reflectance;
} Bounce;

// Grey, coloured on coloured, one colour alone on a surface that treats it unlike the mean, powers as
// photons have them.
static const Bounce bounces[] = {
    {{1, 1, 1}, {0.5, 0.5, 0.5}},     {{2, 1, 0.5}, {0.9, 0.3, 0.1}},        {{0, 3, 0}, {0.9, 0.2, 0.7}},
    {{0, 0, 0.004}, {0.1, 0.1, 0.8}}, {{2e-6, 1e-6, 3e-6}, {0.7, 0.2, 0.4}}, {{1, 1, 1}, {1, 0.5, 0.25}},
};
#define BOUNCES (int)(sizeof bounces / sizeof *bounces)
#define SAMPLES 20000
#define FLOATS  4 // survived, power

// p = 1 and p = 0; a photon without power, of which only 0 can be left.
static const Bounce edges[] = {
    {{0.7, 1, 2}, {1, 1, 1}},   {{0, 2, 0}, {0.3, 1, 0.4}},   {{1, 2, 3}, {0, 0, 0}},
    {{3, 0, 0}, {0, 0.8, 0.9}}, {{0, 0, 0}, {0.5, 0.5, 0.5}},
};
#define EDGES (int)(sizeof edges / sizeof *edges)
#define A_FEW 1000

static double sum(Vec3d c)
{
    return c.x + c.y + c.z;
}

static double component(Vec3d c, int channel)
{
    return channel == 0 ? c.x : channel == 1 ? c.y : c.z;
}

static Vec3d reflected(const Bounce *b)
{
    return vec3d(b->power.x * b->reflectance.x, b->power.y * b->reflectance.y, b->power.z * b->reflectance.z);
}

static const char *inputs_of(const Bounce *b)
{
    return words("Φ = %s W, ρ = %s", text_of_power(b->power), text_of(b->reflectance));
}

static void plan_bounces(Plan *plan, const Bounce *list, int count, long samples)
{
    for (int i = 0; i < count; i++) {
        const Bounce *b = &list[i];
        double arguments[] = {b->power.x, b->power.y, b->power.z, b->reflectance.x, b->reflectance.y, b->reflectance.z};
        plan_call(plan, samples, arguments, 6);
    }
}

static void plan_survival(Plan *plan)
{
    plan_bounces(plan, bounces, BOUNCES, SAMPLES);
}

static bool same_colour(const float *found, Vec3d expected)
{
    double tolerance = 1e-4 * fmax(expected.x, fmax(expected.y, expected.z));
    for (int c = 0; c < 3; c++)
        if (!(fabs((double)found[c] - component(expected, c)) <= tolerance))
            return false;
    return true;
}

static void judge_power(const Bounce *b, double p, const float *result, long number, Finding *finding)
{
    bool survived = result[0] != 0.0f;
    Vec3d expected = survived ? vec3d_along(vec3d(0, 0, 0), reflected(b), 1.0 / p) : b->power;
    if (survived)
        finding_ratios(finding, result + 1, (const double[]){expected.x, expected.y, expected.z}, 3);
    if (same_colour(result + 1, expected))
        return;
    finding_fail(finding, number,
                 survived ? "expected a survivor's power Φρ/p = %s W, found %s W, for %s and so p = %.4g"
                          : "expected an absorbed photon's power to be left alone, %s W, found %s W, for %s, p = %.4g",
                 text_of_power(expected), text_of_power(vec3d_of(result + 1)), inputs_of(b), p);
}

static void judge_survival(const Results *results, Finding *finding)
{
    for (int i = 0; i < BOUNCES; i++) {
        const Bounce *b = &bounces[i];
        double p = sum(reflected(b)) / sum(b->power);
        Sums survived = {0, 0, 0}, ratio[3] = {{0, 0, 0}}, changed = {0, 0, 0};
        const float *result = numbers_of(results, (size_t)i, FLOATS * SAMPLES, finding);
        for (long s = 0; result && s < SAMPLES; s++, result += FLOATS) {
            judge_power(b, p, result, i, finding);
            sums_add(&survived, result[0] != 0.0f);
            sums_add(&changed, result[0] == 0.0f && !same_colour(result + 1, b->power));
            for (int c = 0; c < 3; c++)
                if (result[0] != 0.0f && component(b->power, c) > 0.0)
                    sums_add(&ratio[c], (double)result[1 + c] / component(reflected(b), c) * p);
        }
        if (result)
            finding_p(finding, binomial_p((long)survived.sum, SAMPLES, p), i,
                      "expected a share p = ΣΦρ/ΣΦ = %.4f to survive, found %.4f, for %s", p, sums_mean(&survived),
                      inputs_of(b));
        mean_feature(&survived, p, finding);
        mean_feature(&changed, 0.0, finding);
        for (int c = 0; c < 3; c++)
            if (component(b->power, c) > 0.0)
                mean_feature(&ratio[c], 1.0, finding);
    }
}

// What survivors carry on, taken over all, is what the surface reflects.
static void judge_energy(const Results *results, Finding *finding)
{
    for (int i = 0; i < BOUNCES; i++) {
        const Bounce *b = &bounces[i];
        double p = sum(reflected(b)) / sum(b->power), scale = sum(reflected(b));
        Sums carried = {0, 0, 0};
        const float *result = numbers_of(results, (size_t)i, FLOATS * SAMPLES, finding);
        for (long s = 0; result && s < SAMPLES; s++, result += FLOATS)
            sums_add(&carried, result[0] != 0.0f ? sum(vec3d_of(result + 1)) / scale : 0.0);
        if (result)
            finding_p(finding, normal_p((sums_mean(&carried) - 1.0) / sqrt((1.0 - p) / (p * SAMPLES))), i,
                      "expected survivors to carry on Φρ, averaged over all photons; found %.4f times that, for %s",
                      sums_mean(&carried), inputs_of(b));
        mean_feature(&carried, 1.0, finding);
    }
}

static void plan_edges(Plan *plan)
{
    plan_bounces(plan, edges, EDGES, A_FEW);
}

// One in 2²⁴ random numbers may fall on the wrong side of p = 0 or 1 by how a comparison is written: one is forgiven.
static void judge_edges(const Results *results, Finding *finding)
{
    for (int i = 0; i < EDGES; i++) {
        const Bounce *b = &edges[i];
        bool black = sum(b->power) == 0.0, all = sum(reflected(b)) > 0.0;
        Sums survived = {0, 0, 0};
        const float *result = numbers_of(results, (size_t)i, FLOATS * A_FEW, finding);
        for (long s = 0; result && s < A_FEW; s++, result += FLOATS) {
            sums_add(&survived, result[0] != 0.0f);
            if (black && !same_colour(result + 1, b->power))
                finding_fail(finding, i,
                             "expected a photon without power to stay so, found %s W, for ρ = %s: is 0 divided by 0?",
                             text_of_floats(result + 1), text_of(b->reflectance));
            else if (!black && (all || result[0] == 0.0f))
                judge_power(b, 1.0, result, i, finding);
        }
        double wrong = all ? survived.count - survived.sum : survived.sum;
        if (!black && wrong > 1.0)
            finding_fail(finding, i, "expected %s to survive (p = %d), found a share of %.4f, for %s",
                         all ? "all" : "none", all, sums_mean(&survived), inputs_of(b));
        finding_feature(finding, black ? 0.0 : wrong / survived.count, 0.0);
    }
}

DEFINE_CHECKS(russian_roulette,
              {"survival", "A share p survives, with power Φρ/p", CHECK_SAMPLES, plan_survival, judge_survival},
              {"energy", "Survivors carry Φρ on average", CHECK_ENERGY, plan_survival, judge_energy},
              {"edges", "White, black and coloured surfaces, and a photon without power", CHECK_VALUES, plan_edges,
               judge_edges},
              PICTURE(1))
