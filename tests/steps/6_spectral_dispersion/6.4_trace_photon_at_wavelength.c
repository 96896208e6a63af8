// Step 6.4: the life of a photon of one wavelength.
#include "judge/checks/path_scenes.h"

#define PHOTONS 20000

// wavelength.yaml
#define WAVELENGTH 450.0f
#define POWER      2.0
static const Colour screen_colour = {0.9f, 0.3f, 0.1f};

static void plan_slab(Plan *plan)
{
    plan_paths(plan, SCENES "wavelength.yaml", PHOTONS, 1, 4, plan->step);
}

// Through both faces by the index of the one wavelength; on the screen in its colour, as far as the screen sends that back. Of that
// the books know how much goes on.
static void judge_slab(const Results *results, Finding *finding)
{
    PathCase c = path_case(results, 0, PHOTONS, finding);
    double index = glass_index(glass_find("N-SF11"), (double)WAVELENGTH), sin_i = sqrt(0.75);
    double through = 1.0 - exact_fresnel(0.5, 1.0 / index), sin_t = sin_i / index,
           cos_t = exact_cos_t(0.5, 1.0 / index);
    double reflectance = (double)reflectance_at(screen_colour, WAVELENGTH);
    const double place[3] = {0.2 * sin_t / cos_t + 0.3 * sin_i / 0.5, -0.5, 0.0}, from[3] = {-sin_i, 0.5, 0.0};
    Landed landed = {{0}, place, from};
    Colour hue = spectral_colour(WAVELENGTH);
    for (int i = 0; i < 3; i++)
        landed.flux[i] =
            POWER * (double)colour_channel(hue, i) * reflectance / (double)colour_channel(screen_colour, i);
    expect_share(&c, stored_on(&c, 0).count, 0.0, "stored on glass");
    BatchSum screen = stored_on(&c, 1);
    expect_share(&c, screen.count, through * through, "through both faces of a slab of flint at 450 nm");
    expect_landed(&c, &screen, &landed, "photons of 450 nm behind both faces of a slab of flint");
    expect_value(&c, c.batch.absorbed[0] - c.batch.absorbed[2], 0.0, POWER,
                 "W more taken of one number of a photon's flux than of another (all three are the same wavelength's)");
    expect_books(&c);
}

// wavelength_mirror.yaml
#define MIRROR_WAVELENGTH 620.0f
static const Colour gold = {0.9f, 0.6f, 0.2f}, blue_screen = {0.2f, 0.5f, 0.9f};

static void plan_mirror(Plan *plan)
{
    plan_paths(plan, SCENES "wavelength_mirror.yaml", PHOTONS, 1, 3, plan->step);
}

// Mirror and screen each keep what they reflect at this wavelength, by roulette. What the screen sends on reaches the wall.
static void judge_mirror(const Results *results, Finding *finding)
{
    PathCase c = path_case(results, 0, PHOTONS, finding);
    double mirrored = (double)reflectance_at(gold, MIRROR_WAVELENGTH);
    double scattered = mirrored * (double)reflectance_at(blue_screen, MIRROR_WAVELENGTH);
    const double place[3] = {1.0, 1.0, 0.0}, from[3] = {-sqrt(0.5), -sqrt(0.5), 0.0};
    Landed landed = {{0}, place, from};
    Colour hue = spectral_colour(MIRROR_WAVELENGTH);
    for (int i = 0; i < 3; i++)
        landed.flux[i] = POWER * (double)colour_channel(hue, i) *
                         (double)reflectance_at(blue_screen, MIRROR_WAVELENGTH) /
                         (double)colour_channel(blue_screen, i);
    expect_share(&c, stored_on(&c, 0).count, 0.0, "stored on a mirror");
    BatchSum screen = stored_on(&c, 1), wall = stored_on(&c, 2);
    expect_share(&c, screen.count, mirrored, "mirrored by gold at 620 nm");
    expect_landed(&c, &screen, &landed, "photons of 620 nm behind a gold mirror");
    expect_share(&c, wall.count, scattered, "scattered on to the wall by a blue screen at 620 nm");
    expect_books(&c);
}

DEFINE_CHECKS(trace_photon_at_wavelength,
              {"slab", "Through a slab, and on from a red screen", CHECK_SAMPLES, plan_slab, judge_slab},
              {"mirror", "From a mirror to a screen, and on to the wall", CHECK_SAMPLES, plan_mirror, judge_mirror},
              PICTURE(6))
