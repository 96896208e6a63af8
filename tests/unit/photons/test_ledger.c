// The energy ledger on every example scene: no flux is lost or made, and what chance takes it gives back on average.
#include "unit/test_common.h"

#include <glob.h>

#define PHOTONS FEWER(20000)
#define ENOUGH  50000 // for the smallest cheat to show

// The half that holds by construction, and the half that only right steps keep: chance within 4 standard errors of 0.
static void check_ledger(const Ledger *ledger, const char *what)
{
    for (int c = 0; c < 3; c++) {
        double out = ledger->absorbed[c] + ledger->escaped[c] + ledger->cut[c] + ledger->chance[c];
        if (!(ledger->emitted[c] > 0.0 && fabs(ledger->emitted[c] - out) <= 1e-4 * ledger->emitted[c]))
            fail_msg("%s, channel %d: emitted %.9g W, accounted for %.9g W", what, c, ledger->emitted[c], out);
        if (!(fabs(ledger->chance[c]) <= 4.0 * ledger->chance_error[c] + 1e-6 * ledger->emitted[c]))
            fail_msg("%s, channel %d: chance made %.4g W, %.2f standard errors", what, c, ledger->chance[c],
                     ledger->chance[c] / ledger->chance_error[c]);
    }
}

// What every stored photon must be: finite, not negative unless it is of one wavelength, and coloured ones dark in the other two
// channels.
static void check_photons(const PhotonPass *pass, const Scene *scene, StepChoice play, const char *what)
{
    for (size_t i = 0; i < pass->rest.count; i++) {
        const StoredPhoton *photon = &pass->rest.photons[i];
        bool fine = photon->material < scene->material_count &&
                    material_is_rough(&scene->materials[photon->material]) &&
                    (photon->path == PATH_DIRECT) == (photon->bounce == 0);
        for (int c = 0; c < 3; c++) {
            float power = colour_channel(photon->power, c);
            fine = fine && isfinite(power) && (power >= 0.0f || play.loop == LOOP_WAVELENGTH);
            fine = fine && (photon->colour == WHITE || photon->colour >= BAND_FIRST || photon->colour == RED + c ||
                            power == 0.0f);
        }
        if (!fine)
            fail_msg("%s: photon %zu is wrong (colour %d, path %d, bounce %d)", what, i, photon->colour, photon->path,
                     photon->bounce);
    }
}

static void check_scene(const Scene *scene, const char *name)
{
    for (int i = 0; i < 6; i++) {
        StepChoice play = {i & 1 ? GLOSSY_SOURCE_TEXT : GLOSSY_PHONG, i / 2};
        static const char *const loops[] = {[LOOP_COLOUR] = "3.4", [LOOP_PLAIN] = "1.5", [LOOP_WAVELENGTH] = "6.4"};
        const char *what = words("%s with steps %s,%s", name, i & 1 ? "2.3" : "2.4", loops[play.loop]);
        PhotonPass pass = photons_of(scene, PHOTONS, 1, play);
        check_ledger(&pass.ledger, what);
        check_photons(&pass, scene, play, what);
    }
    assert_int_equal(redraw_cap_count(), 0);
}

TEST(every_example_scene)
{
    glob_t found;
    assert_int_equal(glob("scenes/*.yaml", 0, NULL, &found), 0);
    for (size_t i = 0; i < found.gl_pathc; i++) {
        Scene *scene = scene_from_file(found.gl_pathv[i]);
        check_scene(scene, found.gl_pathv[i]);
        free_all(NULL);
    }
    assert_true(found.gl_pathc >= 5);
    globfree(&found);
}

#define CAMERA "camera: {position: [0, 0, 0.9], target: [0, 0, 0], vertical_fov: 60}\n"

static const char closed_room[] =
    CAMERA "render: {depth: 100}\n"
           "materials:\n"
           "  - {name: wall, type: diffuse, reflectance: [0.7, 0.5, 0.3]}\n"
           "  - {name: copper, type: glossy, diffuse: [0.15, 0.07, 0.04], specular: [0.8, 0.5, 0.35], exponent: 20}\n"
           "  - {name: steel, type: glossy, diffuse: [0, 0.1, 0], specular: [0.9, 0.85, 1], exponent: 1000}\n"
           "  - {name: silver, type: mirror, reflectance: [0.95, 0.9, 0.85]}\n"
           "  - {name: crown, type: glass, index: 1.5}\n"
           "  - {name: flint, type: glass, glass: N-SF11}\n"
           "lights:\n"
           "  - {type: rectangle, corner: [-0.3, 0.95, -0.3], edge_u: [0.6, 0, 0], edge_v: [0, 0, 0.6], "
           "power: [5, 4, 3]}\n"
           "  - {type: sphere, centre: [0.8, -0.8, 0.8], radius: 0.1, radiance: [3, 10, 20]}\n"
           "  - {type: point, position: [-0.8, 0.7, 0.7], power: [1, 0, 1]}\n"
           "  - {type: spot, position: [0, 0.9, 0.8], target: [0, -1, 0], angle: 30, power: [1, 1, 1]}\n"
           "  - {type: beam, position: [0.9, 0.9, 0], target: [0, 0, 0], radius: 0.05, power: [1, 2, 1]}\n"
           "shapes:\n"
           "  - {type: box, low: [-1, -1, -1], high: [1, 1, 1], material: wall}\n"
           "  - {type: rectangle, corner: [-0.99, -0.5, -0.5], edge_u: [0, 1, 0], edge_v: [0, 0, 1], "
           "material: copper}\n"
           "  - {type: rectangle, corner: [-0.5, -0.5, -0.99], edge_u: [1, 0, 0], edge_v: [0, 1, 0], material: steel}\n"
           "  - {type: sphere, centre: [-0.5, -0.6, 0.3], radius: 0.35, material: silver}\n"
           "  - {type: sphere, centre: [0.5, -0.4, -0.4], radius: 0.3, material: crown}\n"
           "  - {type: mesh, file: meshes/diamond.obj, scale: 0.6, translate: [0, 0, 0], material: flint}\n"
           "  - {type: prism, apex: [0.5, 0.5, 0], axis: [0, 0, 1], down: [0, -1, 0], angle: 60, side: 0.3, "
           "length: 0.4, material: flint}\n";

// All kinds of lights and materials in a room without a gap: nothing escapes.
TEST(nothing_escapes_from_a_closed_room)
{
    Scene *scene = scene_from_text(closed_room);
    check_scene(scene, "closed room");
    for (uint64_t seed = 2; seed < 4; seed++) {
        PhotonPass pass = photons_of(scene, FEWER(100000), seed, PLAY_DEFAULT);
        check_ledger(&pass.ledger, "closed room");
        for (int c = 0; c < 3; c++) {
            assert_true(pass.ledger.escaped[c] == 0.0);
            double power = 0.0;
            for (size_t i = 0; i < scene->light_count; i++)
                power += (double)colour_channel(scene->lights[i].power, c);
            assert_within(pass.ledger.emitted[c], power,
                          0.02 * sqrt(1e5 / (double)pass.emitted) * pass.ledger.emitted[c],
                          "emitted power"); // lights are picked by chance
        }
    }
}

// Inside a grey sphere of reflectance ρ lit by Φ, photons arrive with Φ·ρ^k after k bounces: they deposit
// Φ/(1−ρ) in all.
TEST(integrating_sphere)
{
    Scene *scene = scene_from_text(CAMERA "render: {depth: 1000}\n"
                                          "materials: [{name: grey, type: diffuse, reflectance: [0.5, 0.8, 0.9]}]\n"
                                          "lights: [{type: point, position: [0.3, 0.2, 0], power: [1, 1, 1]}]\n"
                                          "shapes: [{type: sphere, centre: [0, 0, 0], radius: 1, material: grey}]\n");
    PhotonPass pass = photons_of(scene, FEWER(100000), 1, PLAY_DEFAULT);
    double arrived[3] = {0};
    for (size_t i = 0; i < pass.rest.count; i++) {
        assert_within(vec3_length(pass.rest.photons[i].position), 1.0, 1e-6, "photon on the sphere");
        for (int c = 0; c < 3; c++)
            arrived[c] += (double)colour_channel(pass.rest.photons[i].power, c);
    }
    const double expected[3] = {2.0, 5.0, 10.0};
    for (int c = 0; c < 3; c++) // absorbed = (1−ρ)·arrived exactly; chance is their distance to the right answer
        assert_within(arrived[c], expected[c], 4.0 * pass.ledger.chance_error[c] * expected[c], "flux that arrives");
}

// The ledger's second half is no tautology: a step that cheats shows.
static bool stingy_roulette(Colour *power, Colour reflectance, Rng *rng)
{
    *power = colour_mul(*power, reflectance);
    return rng_float(rng) < 0.9f;
}

static bool unweighted_phong(Vec3 direction, Vec3 normal, float exponent, Rng *rng, Vec3 *out, float *weight)
{
    bool above = steps.scatter_glossy_phong(direction, normal, exponent, rng, out, weight);
    *weight = 1.0f;
    return above;
}

static float fresnel_without_total_reflection(float cos_i, float eta)
{
    (void)cos_i;
    (void)eta;
    return 0.04f;
}

static bool ledger_notices(const Scene *scene)
{
    PhotonPass pass = pass_of(scene, (PhotonPassOptions){.photons = ENOUGH, .seed = 1});
    for (int c = 0; c < 3; c++)
        if (fabs(pass.ledger.chance[c]) > 4.0 * pass.ledger.chance_error[c])
            return true;
    return false;
}

TEST(cheating_steps_are_noticed)
{
    Scene *scene = scene_from_text(closed_room);
    steps_play(PLAY_DEFAULT);
    const Steps honest = steps;
    Steps cheating[4] = {honest, honest, honest, honest};
    cheating[1].russian_roulette = stingy_roulette;
    cheating[2].scatter_glossy = unweighted_phong;
    cheating[3].fresnel = fresnel_without_total_reflection;
    for (int i = 0; i < 4; i++) {
        steps = cheating[i];
        if (ledger_notices(scene) != (i > 0))
            fail_msg("cheat %d is %s", i, i > 0 ? "not noticed" : "none, and is noticed");
    }
    steps = honest;
}
