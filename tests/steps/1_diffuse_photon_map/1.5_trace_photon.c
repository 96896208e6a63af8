// Step 1.5: the life of a photon, as a loop.
#include "judge/checks/path_scenes.h"

#define GLASS_PHOTONS 20000

static void plan_glass(Plan *plan)
{
    plan_paths(plan, SCENES "glass.yaml", GLASS_PHOTONS, 1, 2, plan->step);
}

// Half of the photons meet this glass at 60°, where the loop takes them by the mean index. z: of the beam.
static void expect_faces(PathCase *c, int glass, double index, double z, const char *above, const char *below)
{
    double cos_i = 0.5, sin_i = sqrt(0.75);
    double reflected = exact_fresnel(cos_i, 1.0 / index), cos_t = exact_cos_t(cos_i, 1.0 / index),
           sin_t = sin_i / index;
    const double up[3] = {0.5 * sin_i / cos_i, 0.5, z}, up_from[3] = {-sin_i, -cos_i, 0.0};
    const double down[3] = {0.5 * sin_t / cos_t, -0.5, z}, down_from[3] = {-sin_t, cos_t, 0.0};
    const Landed up_landed = {{6.0, 4.0, 2.0}, up, up_from}, down_landed = {{6.0, 4.0, 2.0}, down, down_from};
    expect_share(c, stored_on(c, glass).count, 0.0, "stored on glass");
    BatchSum over = stored_on(c, glass + 1), under = stored_on(c, glass + 2);
    expect_share(c, over.count, 0.5 * reflected, above);
    expect_landed(c, &over, &up_landed, "photons reflected by glass");
    expect_share(c, under.count, 0.5 * (1.0 - reflected), below);
    expect_landed(c, &under, &down_landed, "photons refracted by glass");
}

static void judge_glass(const Results *results, Finding *finding)
{
    PathCase c = path_case(results, 0, GLASS_PHOTONS, finding);
    expect_faces(&c, 0, 1.5, 0.0, "reflected up from glass of index 1.5 at 60°",
                 "refracted by glass of index 1.5 at 60°");
    expect_faces(&c, 3, 1.7, 9.0, "reflected up from glass of mean index 1.7 at 60°",
                 "refracted by glass of mean index 1.7 at 60°");
    expect_share(&c, stored_of_colour(&c, WHITE), 1.0, "stored white behind glass (the loop does not split them)");
    expect_books(&c);
}

DEFINE_CHECKS(trace_photon,
              {"stored", "Photons are stored wherever they land, with the power they arrive with", CHECK_SAMPLES,
               plan_furnace, judge_furnace},
              {"diffuse", "Photons fly on from diffuse surfaces", CHECK_SAMPLES, plan_spot, judge_spot},
              {"glossy", "Photons fly on from glossy surfaces", CHECK_SAMPLES, plan_glossy_spot, judge_glossy_spot},
              {"mirror", "Photons fly on from mirrors, and leave nothing there", CHECK_SAMPLES, plan_mirrors,
               judge_mirrors},
              {"glass", "Photons fly on from glass, and leave nothing there", CHECK_SAMPLES, plan_glass, judge_glass},
              {"energy", "No energy is lost or made", CHECK_ENERGY, plan_room, judge_room}, PICTURE(1))
