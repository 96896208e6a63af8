// What leaves a small plate in the middle of a ball: see scenes/spot.yaml and scenes/glossy_spot.yaml.
#include "judge/checks/path_scenes.h"

#include <math.h>
#include <stdio.h>

#define SPOT_PHOTONS 20000
static const double plate_reflectance[3] = {0.8, 0.5, 0.3};

void plan_spot(Plan *plan)
{
    plan_paths(plan, SCENES "spot.yaml", SPOT_PHOTONS, 1, 2, plan->step);
}

void plan_glossy_spot(Plan *plan)
{
    plan_paths(plan, SCENES "glossy_spot.yaml", SPOT_PHOTONS, 1, 2, plan->step);
}

// What leaves the plate: how many, and the mean and variance of their directions.
typedef struct {
    double share, mean[3], variance[3];
} Onward;

// The plate is the first material, the ball the second; both hold every photon that meets them.
static void expect_spot(PathCase *c, const Onward *onward, const char *kind)
{
    static const double origin[3] = {0.0, 0.0, 0.0}, back[3] = {-0.8, 0.6, 0.0};
    BatchSum plate = stored_on(c, 0), ball = stored_on(c, 1);
    char what[200];
    snprintf(what, sizeof what, "stored on a %s plate that all of them meet", kind);
    expect_share(c, plate.count, 1.0, what);
    Landed arriving = {{scene_power[0], scene_power[1], scene_power[2]}, origin, back};
    snprintf(what, sizeof what, "photons on a %s plate", kind);
    expect_landed(c, &plate, &arriving, what);
    snprintf(what, sizeof what, "to fly on from a %s plate and land", kind);
    expect_share(c, ball.count, onward->share, what);
    snprintf(what, sizeof what, "the direction in which photons leave a %s plate", kind);
    for (int i = 0; i < 3; i++) {
        double mean = ball.place[i] / ball.count;
        expect_mean(c, mean, onward->mean[i], sqrt(onward->variance[i] / ball.count), what);
        finding_feature(c->finding, mean + ball.from[i] / ball.count, 0.0);
        if (ball.count > 0.0 && !(fabs(mean + ball.from[i] / ball.count) < 2e-3))
            finding_fail(c->finding, c->number,
                         "expected photons to fly on from where they landed; found them starting elsewhere");
    }
    expect_value(c, c->batch.escaped[0], 0.0, 3.0, "W of the 3 W of red to leave a closed ball");
    expect_books(c);
}

// Cosine hemisphere: mean 2/3 along the normal; variances 1/4, 1/18, 1/4.
void judge_spot(const Results *results, Finding *finding)
{
    PathCase c = path_case(results, 0, SPOT_PHOTONS, finding);
    Onward onward = {survival(scene_power, plate_reflectance), {0.0, 2.0 / 3.0, 0.0}, {0.25, 1.0 / 18.0, 0.25}};
    expect_spot(&c, &onward, "diffuse");
    BatchSum ball = stored_on(&c, 1);
    Landed landed = {{0}, NULL, NULL};
    for (int i = 0; i < 3; i++)
        landed.flux[i] = scene_power[i] * plate_reflectance[i] / onward.share;
    expect_landed(&c, &ball, &landed, "photons that survived a diffuse surface");
}

// Sums over the lobe of step 2.4 about the mirror direction (0.8, 0.6, 0): chance to stay above the plate, first and
// second moments of the direction, and of the weight (n+2)/(n+1)·cosθ.
typedef struct {
    double above, first[3], second[3], weight, weight2;
} LobeSums;

static LobeSums lobe_sums(double exponent)
{
    enum { RINGS = 400, SPOKES = 360 };
    LobeSums sums = {0};
    for (int i = 0; i < RINGS; i++) {
        double cos_a = pow((i + 0.5) / RINGS, 1.0 / (exponent + 1.0)), sin_a = sqrt(1.0 - cos_a * cos_a);
        for (int j = 0; j < SPOKES; j++) {
            double phi = 2.0 * (double)PI * (j + 0.5) / SPOKES;
            double u = sin_a * cos(phi); // along (−0.6, 0.8, 0)
            double d[3] = {0.8 * cos_a - 0.6 * u, 0.6 * cos_a + 0.8 * u, sin_a * sin(phi)};
            if (d[1] <= 0.0)
                continue;
            double share = 1.0 / (RINGS * SPOKES), weight = (exponent + 2.0) / (exponent + 1.0) * d[1];
            sums.above += share;
            sums.weight += share * weight;
            sums.weight2 += share * weight * weight;
            for (int k = 0; k < 3; k++) {
                sums.first[k] += share * d[k];
                sums.second[k] += share * d[k] * d[k];
            }
        }
    }
    return sums;
}

void judge_glossy_spot(const Results *results, Finding *finding)
{
    static const double diffuse[3] = {0.3, 0.2, 0.1}, specular[3] = {0.5, 0.3, 0.2};
    static const double cosine_first[3] = {0.0, 2.0 / 3.0, 0.0}, cosine_second[3] = {0.25, 0.5, 0.25};
    PathCase c = path_case(results, 0, SPOT_PHOTONS, finding);
    LobeSums lobe = lobe_sums(20.0);
    double d = survival(scene_power, diffuse), s = survival(scene_power, specular);
    Onward onward = {.share = d + s * lobe.above};
    for (int i = 0; i < 3; i++) {
        onward.mean[i] = (d * cosine_first[i] + s * lobe.first[i]) / onward.share;
        onward.variance[i] =
            (d * cosine_second[i] + s * lobe.second[i]) / onward.share - onward.mean[i] * onward.mean[i];
    }
    expect_spot(&c, &onward, "glossy");

    // A photon carries on Φ·ρ_d/d with chance d, Φ·ρ_s/s·weight with chance s.
    BatchSum ball = stored_on(&c, 1);
    for (int i = 0; i < 3; i++) {
        double mean = diffuse[i] + specular[i] * lobe.weight;
        double square = diffuse[i] * diffuse[i] / d + specular[i] * specular[i] / s * lobe.weight2;
        expect_mean(&c, ball.flux[i] / scene_power[i], mean, sqrt((square - mean * mean) / SPOT_PHOTONS),
                    "the share of a channel's power that leaves a glossy plate");
    }
}
