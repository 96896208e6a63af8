// Step 3.4: the life of a photon, as a recursion that carries the colour.
#include "judge/checks/path_scenes.h"

#define PHOTONS 20000

// A white beam at one face of glass: F_c and their mean, per channel.
typedef struct {
    double sin_i, cos_i, z, share; // share: of the light's photons that are in this beam
    double eta[3], reflected[3], mean;
    double up;         // 1: reflected upwards, −1: downwards
    const char *where; // "entering glass of …"
} Face;

static Face face(double sin_i, const double index[3], bool entering, double z, double share, const char *where)
{
    Face f = {.sin_i = sin_i,
              .cos_i = sqrt(1.0 - sin_i * sin_i),
              .z = z,
              .share = share,
              .up = entering ? 1.0 : -1.0,
              .where = where};
    for (int i = 0; i < 3; i++) {
        f.eta[i] = entering ? 1.0 / index[i] : index[i];
        f.reflected[i] = exact_fresnel(f.cos_i, f.eta[i]);
        f.mean += f.reflected[i] / 3.0;
    }
    return f;
}

// Reflected photons: white, on `material`, Φ_c·F_c/F̄ each.
static void expect_reflected(PathCase *c, const Face *f, int material)
{
    const double place[3] = {0.5 * f->sin_i / f->cos_i, 0.5 * f->up, f->z};
    const double from[3] = {-f->sin_i, -f->up * f->cos_i, 0.0};
    Landed landed = {{0}, place, from};
    for (int i = 0; i < 3; i++)
        landed.flux[i] = scene_power[i] * f->reflected[i] / f->mean / f->share;
    expect_share(c, c->batch.stored[material][WHITE].count, f->share * f->mean,
                 words("reflected white by the mean of the three Fresnel shares, %s", f->where));
    expect_landed(c, &c->batch.stored[material][WHITE], &landed,
                  words("white photons (power times F_c over the mean F), reflected %s,", f->where));
    double coloured = 0.0;
    for (int i = 0; i < 3; i++)
        coloured += c->batch.stored[material][RED + i].count;
    expect_share(c, coloured, 0.0, words("coloured though reflected, %s", f->where));
}

// Refracted photons: each white one becomes one of each colour that gets through, with Φ_c·(1−F_c)/(1−F̄).
static void expect_refracted(PathCase *c, const Face *f, int material)
{
    for (int i = 0; i < 3; i++) {
        const BatchSum *sum = &c->batch.stored[material][RED + i];
        double sin_t = fmin(1.0, f->sin_i * f->eta[i]), cos_t = exact_cos_t(f->cos_i, f->eta[i]);
        const double place[3] = {0.5 * sin_t / cos_t, -0.5 * f->up, f->z}, from[3] = {-sin_t, f->up * cos_t, 0.0};
        Landed landed = {{0}, place, from};
        landed.flux[i] = scene_power[i] * (1.0 - f->reflected[i]) / (1.0 - f->mean) / f->share;
        bool total = f->reflected[i] >= 1.0;
        expect_share(
            c, sum->count, total ? 0.0 : f->share * (1.0 - f->mean),
            words(total ? "of %s (total reflection) through, %s" : "of %s refracted, %s", channel_names[i], f->where));
        if (total)
            continue;
        expect_landed(c, sum, &landed,
                      words("%s photons (power times (1-F_c)/(1-mean F)), refracted by their own index %s,",
                            channel_names[i], f->where));
    }
    expect_share(c, c->batch.stored[material][WHITE].count, 0.0, words("white behind dispersing glass, %s", f->where));
}

static void plan_entering(Plan *plan)
{
    plan_paths(plan, SCENES "glass.yaml", PHOTONS, 1, 2, plan->step);
}

// The first glass has a single index: it splits nothing, and the weights are 1.
static void judge_single(PathCase *c)
{
    static const double one[3] = {1.5, 1.5, 1.5};
    Face f = face(sqrt(0.75), one, true, 0.0, 0.5, "at glass of a single index");
    double sin_t = f.sin_i * f.eta[0], cos_t = exact_cos_t(f.cos_i, f.eta[0]);
    const double place[3] = {0.5 * sin_t / cos_t, -0.5, 0.0}, from[3] = {-sin_t, cos_t, 0.0};
    const Landed landed = {{6.0, 4.0, 2.0}, place, from};
    BatchSum below = stored_on(c, 2);
    expect_reflected(c, &f, 1);
    expect_share(c, below.count, 0.5 * (1.0 - f.mean), "refracted by glass of a single index");
    expect_landed(c, &below, &landed, "photons refracted by glass of a single index");
    expect_share(c, below.count - c->batch.stored[2][WHITE].count, 0.0, "coloured by glass of a single index");
}

static void judge_entering(const Results *results, Finding *finding)
{
    static const double flint[3] = {1.2, 1.5, 2.4};
    PathCase c = path_case(results, 0, PHOTONS, finding);
    expect_share(&c, stored_on(&c, 0).count + stored_on(&c, 3).count, 0.0, "stored on glass");
    judge_single(&c);
    Face f = face(sqrt(0.75), flint, true, 9.0, 0.5, "on the way into glass of indices 1.2, 1.5, 2.4 at 60°");
    expect_reflected(&c, &f, 4);
    expect_refracted(&c, &f, 5);
    double red = c.batch.stored[5][RED].count;
    expect_value(&c, c.batch.stored[5][GREEN].count - red, 0.0, 1.0,
                 "more green photons than red where white ones split");
    expect_value(&c, c.batch.stored[5][BLUE].count - red, 0.0, 1.0,
                 "more blue photons than red where white ones split");
    expect_books(&c);
}

static void plan_leaving(Plan *plan)
{
    plan_paths(plan, SCENES "leaving.yaml", PHOTONS, 1, 2, plan->step);
}

static void judge_leaving(const Results *results, Finding *finding)
{
    static const double flint[3] = {1.3, 1.45, 1.7};
    PathCase c = path_case(results, 0, PHOTONS, finding);
    expect_share(&c, stored_on(&c, 0).count, 0.0, "stored on glass");
    Face partly = face(0.625, flint, false, 0.0, 0.5, "on the way out of glass, past the critical angle for blue");
    expect_reflected(&c, &partly, 2);
    expect_refracted(&c, &partly, 1);
    Face total = face(0.9, flint, false, 9.0, 0.5, "on the way out of glass, past every critical angle");
    expect_reflected(&c, &total, 4);
    expect_refracted(&c, &total, 3);
    expect_books(&c);
}

static void plan_slab(Plan *plan)
{
    plan_paths(plan, SCENES "slab.yaml", PHOTONS, 1, 4, plan->step);
}

// Through both faces: (1−F̄) at the first, where white splits, (1−F_c) at the second, where nothing splits.
static void expect_through(PathCase *c, const Face *f, int screen)
{
    for (int i = 0; i < 3; i++) {
        const BatchSum *sum = &c->batch.stored[screen][RED + i];
        double sin_t = f->sin_i * f->eta[i], cos_t = exact_cos_t(f->cos_i, f->eta[i]);
        const double place[3] = {0.2 * sin_t / cos_t + 0.3 * f->sin_i / f->cos_i, -0.5, 0.0};
        const double from[3] = {-f->sin_i, f->cos_i, 0.0};
        Landed landed = {{0}, place, from};
        landed.flux[i] = scene_power[i] * (1.0 - f->reflected[i]) / (1.0 - f->mean);
        expect_share(c, sum->count, (1.0 - f->mean) * (1.0 - f->reflected[i]),
                     words("of %s through both faces of a slab", channel_names[i]));
        expect_landed(c, sum, &landed, words("%s photons behind both faces of a slab", channel_names[i]));
    }
    expect_share(c, c->batch.stored[screen][WHITE].count, 0.0, "white behind both faces of a slab that disperses");
}

static void judge_slab(const Results *results, Finding *finding)
{
    static const double flint[3] = {1.2, 1.5, 2.4};
    PathCase c = path_case(results, 0, PHOTONS, finding);
    Face f = face(sqrt(0.75), flint, true, 0.0, 1.0, "by a slab");
    expect_share(&c, stored_on(&c, 0).count, 0.0, "stored on glass");
    expect_through(&c, &f, 1);
    expect_share(&c, c.batch.stored[2][WHITE].count, 0.0,
                 "white where a screen scatters coloured light to (a coloured photon never gets white again)");
    for (int i = 0; i < 3; i++) {
        const BatchSum *screen = &c.batch.stored[1][RED + i], *roof = &c.batch.stored[2][RED + i];
        expect_value(&c,
                     screen->flux[(i + 1) % 3] + screen->flux[(i + 2) % 3] + roof->flux[(i + 1) % 3] +
                         roof->flux[(i + 2) % 3],
                     0.0, 1.0, "W in channels that are not a photon's colour");
    }
    expect_books(&c);
}

DEFINE_CHECKS(trace_photon_in_colour,
              {"stored", "Photons are stored wherever they land, with the power they arrive with", CHECK_SAMPLES,
               plan_furnace, judge_furnace},
              {"diffuse", "Photons fly on from diffuse surfaces", CHECK_SAMPLES, plan_spot, judge_spot},
              {"glossy", "Photons fly on from glossy surfaces", CHECK_SAMPLES, plan_glossy_spot, judge_glossy_spot},
              {"mirror", "Photons fly on from mirrors, and leave nothing there", CHECK_SAMPLES, plan_mirrors,
               judge_mirrors},
              {"entering", "White light splits as it enters glass", CHECK_SAMPLES, plan_entering, judge_entering},
              {"leaving", "Glass reflects totally, colour by colour", CHECK_SAMPLES, plan_leaving, judge_leaving},
              {"slab", "Coloured photons keep their colour", CHECK_SAMPLES, plan_slab, judge_slab},
              {"energy", "No energy is lost or made", CHECK_ENERGY, plan_room, judge_room}, PICTURE(3))
