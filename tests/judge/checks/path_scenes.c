#include "judge/checks/path_scenes.h"

#include <math.h>
#include <stdio.h>

const double scene_power[3] = {3.0, 2.0, 1.0};

double survival(const double flux[3], const double reflectance[3])
{
    double before = 0.0, after = 0.0;
    for (int i = 0; i < 3; i++) {
        before += flux[i];
        after += flux[i] * reflectance[i];
    }
    return after / before;
}

// ---- furnace.yaml: how often and with what power photons land ----

#define FURNACE_PHOTONS 20000

// A photon carries 1.5e-12 W of red: however dim it is, it flies on.
static const double furnace_power[3] = {3e-8, 2e-8, 1e-8};

void plan_furnace(Plan *plan)
{
    plan_paths(plan, SCENES "furnace.yaml", FURNACE_PHOTONS, 1, BATCH_BOUNCES, plan->step);
}

// Of the photons that met `before` surfaces before: a share of Σ Φρ^k / Σ Φ, each with Φρ^k over that share.
static double expect_bounce(PathCase *c, int before)
{
    static const double reflectance[3] = {0.8, 0.5, 0.3};
    double power[3];
    for (int i = 0; i < 3; i++)
        power[i] = pow(reflectance[i], before);
    double share = survival(furnace_power, power);
    char which[200];
    snprintf(which, sizeof which,
             before ? "stored after %d bounce%s" : "stored on the first surface that they meet (before the roulette)",
             before, before == 1 ? "" : "s");
    const BatchSum *sum = &c->batch.bounces[before];
    expect_share(c, sum->count, share, which);
    Landed landed = {{0}, NULL, NULL};
    for (int i = 0; i < 3; i++)
        landed.flux[i] = furnace_power[i] * power[i] / share;
    snprintf(which, sizeof which, "photons on a diffuse wall after %d bounce%s (with the power that they arrive with)",
             before, before == 1 ? "" : "s");
    expect_landed(c, sum, &landed, which);
    return share;
}

// From the second surface on, they land evenly all over the ball: variance 1/3 along each axis.
static void expect_even(PathCase *c, int before)
{
    const BatchSum *sum = &c->batch.bounces[before];
    for (int i = 0; i < 3; i++)
        expect_mean(c, sum->place[i] / sum->count, 0.0, sqrt(1.0 / 3.0 / sum->count),
                    "the place on a ball lit from inside that photons land at after a diffuse bounce");
}

void judge_furnace(const Results *results, Finding *finding)
{
    PathCase c = path_case(results, 0, FURNACE_PHOTONS, finding);
    double observed[BATCH_BOUNCES], expected[BATCH_BOUNCES];
    for (int before = 0; before < BATCH_BOUNCES; before++) {
        expected[before] = FURNACE_PHOTONS * expect_bounce(&c, before);
        observed[before] = c.batch.bounces[before].count;
    }
    finding_histogram(finding, "photons at rest by the bounces before", 0.0, BATCH_BOUNCES, observed, expected,
                      BATCH_BOUNCES);
    expect_share(&c, c.batch.paths[PATH_DIRECT], 1.0,
                 "stored as direct from the light (a photon that bounces is the same photon: it must keep what it is)");
    expect_even(&c, 1);
    expect_even(&c, 2);
    expect_value(&c, c.batch.escaped[0], 0.0, furnace_power[0], "W of the 3e-08 W of red to leave a closed ball");
    expect_books(&c);
}

// ---- mirrors.yaml, corridor.yaml ----

#define MIRROR_PHOTONS   10000
#define CORRIDOR_PHOTONS 1000
#define CORRIDOR_DEPTH   20

void plan_mirrors(Plan *plan)
{
    plan_paths(plan, SCENES "mirrors.yaml", MIRROR_PHOTONS, 1, 2, plan->step);
    plan_paths(plan, SCENES "corridor.yaml", CORRIDOR_PHOTONS, 1, CORRIDOR_DEPTH, plan->step);
}

// Half of the photons go to either mirror.
static void judge_two_mirrors(PathCase *c)
{
    static const double copper[3] = {0.9, 0.6, 0.3};
    double lean = 20.0 * (double)PI / 180.0;
    const double place[3] = {0.0, 0.5, 0.0}, from[3] = {0.0, -1.0, 0.0};
    const double far_place[3] = {0.5 * tan(lean), 0.5, 5.0}, far_from[3] = {-sin(lean), -cos(lean), 0.0};
    Landed landed = {{0}, place, from}, far = {{0}, far_place, far_from};
    double share = survival(scene_power, copper);
    for (int i = 0; i < 3; i++) {
        landed.flux[i] = 2.0 * scene_power[i] * copper[i] / share;
        far.flux[i] = 2.0 * scene_power[i];
    }
    expect_share(c, stored_on(c, 0).count + stored_on(c, 2).count, 0.0, "stored on mirrors");
    BatchSum screen = stored_on(c, 1), far_screen = stored_on(c, 3);
    expect_share(c, screen.count, 0.5 * share,
                 "to survive a mirror of reflectance (0.9, 0.6, 0.3) and be stored behind it");
    expect_landed(c, &screen, &landed, "photons behind a mirror of reflectance (0.9, 0.6, 0.3)");
    expect_share(c, far_screen.count, 0.5, "stored behind a perfect mirror");
    expect_landed(c, &far_screen, &far, "photons behind a mesh mirror, whose hit.normal leans,");
    expect_books(c);
}

void judge_mirrors(const Results *results, Finding *finding)
{
    PathCase c = path_case(results, 0, MIRROR_PHOTONS, finding);
    judge_two_mirrors(&c);
    PathCase corridor = path_case(results, 1, CORRIDOR_PHOTONS, finding);
    expect_share(&corridor, stored_on(&corridor, 0).count, 0.0, "stored on mirrors");
    double left =
        corridor.batch.cut[0] / scene_power[0] * CORRIDOR_PHOTONS; // a grey mirror: a survivor keeps its power
    expect_share(&corridor, floor(left + 0.5), pow(0.99, CORRIDOR_DEPTH),
                 "to fly 20 times between mirrors of reflectance 0.99, where the depth limit ends them");
    expect_books(&corridor);
}

// ---- room.yaml: the energy of all materials together ----

#define ROOM_PHOTONS 4000

void plan_room(Plan *plan)
{
    plan_paths(plan, SCENES "room.yaml", ROOM_PHOTONS, 1, 60, plan->step);
}

// The walls and the block alone take light: (1−ρ) of what is stored on them, if all that arrives is stored, once.
static void expect_stored_once(PathCase *c)
{
    static const double wall[3] = {0.7, 0.5, 0.3}, block[3] = {0.3, 0.6, 0.8};
    BatchSum on_wall = stored_on(c, 0), on_block = stored_on(c, 1);
    for (int i = 0; i < 3; i++) {
        double taken = on_wall.flux[i] * (1.0 - wall[i]) + on_block.flux[i] * (1.0 - block[i]);
        double scale = c->batch.absorbed[i] > 0.0 ? c->batch.absorbed[i] : 1.0;
        finding_feature(c->finding, taken / scale - 1.0, 0.0);
        if (!(fabs(taken / scale - 1.0) <= 1e-3))
            finding_fail(
                c->finding, c->number,
                "expected each photon to be stored once, with the power it arrives with, wherever it meets a rough "
                "surface; found %.4g times the %s power stored that arrived",
                taken / scale, channel_names[i]);
    }
}

void judge_room(const Results *results, Finding *finding)
{
    PathCase c = path_case(results, 0, ROOM_PHOTONS, finding);
    expect_share(&c, stored_on(&c, 2).count, 0.0, "stored on a mirror");
    expect_share(&c, stored_on(&c, 3).count + stored_on(&c, 4).count, 0.0, "stored on glass");
    expect_stored_once(&c);
    for (int i = 0; i < 3; i++) {
        double other = 0.0; // power that a photon of one colour carries in the two other channels
        for (int m = 0; m < BATCH_MATERIALS; m++)
            other += c.batch.stored[m][RED + (i + 1) % 3].flux[i] + c.batch.stored[m][RED + (i + 2) % 3].flux[i];
        expect_value(&c, other, 0.0, 1.0, "W in channels that are not a photon's colour");
        expect_value(&c, c.batch.escaped[i], 0.0, scene_power[i], "W to leave a closed room");
    }
    expect_books(&c);
}
