// White stays white: what glass may do to colour, and how the loop (step 1.5) and the recursion (3.4) agree.
#include "unit/test_common.h"

// Light falls straight through four panes of the glass `material` into a black hemisphere of walls behind them.
static Scene *panes(const char *glass)
{
    return scene_from_text(
        words("camera: {position: [0, 0, -1], target: [0, 0, 0], vertical_fov: 40}\n"
              "render: {depth: 1000}\n"
              "materials:\n"
              "  - {name: black, type: diffuse, reflectance: [0, 0, 0]}\n"
              "  - {name: pane, type: glass, %s}\n"
              "lights:\n"
              "  - {type: beam, position: [0, 0, -0.5], target: [0, 0, 0], radius: 0.1, power: [1, 1, 1]}\n"
              "shapes:\n"
              "  - {type: box, low: [-1, -1, 0.00], high: [1, 1, 0.01], material: pane}\n"
              "  - {type: box, low: [-1, -1, 0.02], high: [1, 1, 0.03], material: pane}\n"
              "  - {type: box, low: [-1, -1, 0.04], high: [1, 1, 0.05], material: pane}\n"
              "  - {type: box, low: [-1, -1, 0.06], high: [1, 1, 0.07], material: pane}\n"
              "  - {type: rectangle, corner: [-1, -1, 1], edge_u: [2, 0, 0], edge_v: [0, 2, 0], material: black}\n",
              glass));
}

// Where the flux of each channel got to, and how many photons of each colour.
typedef struct {
    double sum[3], error[3]; // W; standard error
    long count[4];
} Arrived;

static Arrived arrived(const PhotonPass *pass)
{
    Arrived result = {{0}, {0}, {0}};
    Mean mean[3] = {{0}};
    for (size_t i = 0; i < pass->rest.count; i++) {
        const StoredPhoton *photon = &pass->rest.photons[i];
        result.count[photon->colour]++;
        for (int c = 0; c < 3; c++)
            mean_add(&mean[c], (double)colour_channel(photon->power, c) * (double)pass->emitted);
    }
    for (int c = 0; c < 3; c++) {
        mean[c].count = pass->emitted; // photons reflected away count as 0
        result.sum[c] = mean_value(&mean[c]);
        result.error[c] = mean_error(&mean[c]);
    }
    return result;
}

// m panes, each surface reflecting R, let (1 − R)/(1 + (2m−1)R) through (Stokes 1862: all reflections back and forth).
static double through_panes(double index, int m)
{
    double r = (index - 1.0) / (index + 1.0) * ((index - 1.0) / (index + 1.0));
    return (1.0 - r) / (1.0 + (2 * m - 1) * r);
}

TEST(panes_of_one_index)
{
    for (int loop = 0; loop < 2; loop++) {
        Scene *scene = panes(loop ? "indices: [1.5, 1.5, 1.5]" : "index: 1.5");
        PhotonPass pass = photons_of(scene, FEWER(100000), 1, (StepChoice){GLOSSY_PHONG, loop});
        Arrived at = arrived(&pass);
        assert_int_equal(at.count[RED] + at.count[GREEN] + at.count[BLUE], 0);
        assert_true(at.sum[0] == at.sum[1] && at.sum[1] == at.sum[2]); // the same numbers, not just nearly
        assert_within(at.sum[0], through_panes(1.5, 4), 3.0 * at.error[0], "flux behind four panes"); // 0.75
    }
}

// As dispersion goes to zero the three colours carry what white carried, and arrive as one white again.
TEST(panes_of_nearly_one_index)
{
    Scene *scene = panes("indices: [1.5, 1.500001, 1.500002]");
    PhotonPass pass = photons_of(scene, FEWER(200000), 1, PLAY_DEFAULT);
    Arrived at = arrived(&pass);
    assert_int_equal(at.count[WHITE], 0);
    for (int c = 0; c < 3; c++) {
        int next = (c + 1) % 3;
        assert_true(at.count[RED + c] > pass.emitted / 2);
        assert_within(at.sum[c], through_panes(1.5, 4), 4.0 * at.error[c], "flux of one colour");
        assert_within(at.sum[c], at.sum[next], 4.0 * hypot(at.error[c], at.error[next]), "two colours");
    }
}

// Strong dispersion: each colour by its own index, though white photons choose by the mean of three reflectances.
TEST(panes_of_strong_dispersion)
{
    const double index[3] = {1.3, 1.6, 2.4};
    Scene *scene = panes("indices: [1.3, 1.6, 2.4]");
    PhotonPass pass = photons_of(scene, FEWER(200000), 1, PLAY_DEFAULT);
    Arrived at = arrived(&pass);
    for (int c = 0; c < 3; c++) {
        assert_within(at.sum[c], through_panes(index[c], 4), 3.0 * at.error[c], "flux of one colour");
        assert_within(pass.ledger.escaped[c], 1.0 - through_panes(index[c], 4), 0.01 * sqrt(2e5 / (double)pass.emitted),
                      "flux reflected");
    }
}

// What is reflected at the outside of dispersing glass has not been inside: it stays white, its channels
// weighted by their own reflectance F_c = ((n−1)/(n+1))².
TEST(reflected_light_stays_white)
{
    Scene *scene = scene_from_text(
        "camera: {position: [0, 0, -1], target: [0, 0, 0], vertical_fov: 40}\n"
        "materials:\n"
        "  - {name: black, type: diffuse, reflectance: [0, 0, 0]}\n"
        "  - {name: strong, type: glass, indices: [1.3, 1.6, 2.4]}\n"
        "lights: [{type: beam, position: [0, 0, -0.5], target: [0, 0, 0], radius: 0.1, power: [1, 1, 1]}]\n"
        "shapes:\n"
        "  - {type: rectangle, corner: [-1, -1, 0], edge_u: [0, 2, 0], edge_v: [2, 0, 0], material: strong}\n"
        "  - {type: rectangle, corner: [-1, -1, 1], edge_u: [2, 0, 0], edge_v: [0, 2, 0], material: black}\n"
        "  - {type: rectangle, corner: [-1, -1, -1], edge_u: [2, 0, 0], edge_v: [0, 2, 0], material: black}\n");
    const double index[3] = {1.3, 1.6, 2.4};
    PhotonPass pass = photons_of(scene, FEWER(100000), 1, PLAY_DEFAULT);
    Mean white[3] = {{0}};
    for (size_t i = 0; i < pass.rest.count; i++) {
        const StoredPhoton *photon = &pass.rest.photons[i];
        assert_true((photon->colour == WHITE) == (photon->position.z < 0.0f));
        for (int c = 0; photon->colour == WHITE && c < 3; c++)
            mean_add(&white[c], (double)colour_channel(photon->power, c) * (double)pass.emitted);
    }
    for (int c = 0; c < 3; c++) {
        double r = (index[c] - 1.0) / (index[c] + 1.0);
        white[c].count = pass.emitted;
        assert_mean(&white[c], r * r, "reflected flux of one channel");
    }
}

// A grey room with glass of one index: no photon is ever coloured, no channel ever differs.
TEST(a_grey_room_stays_grey)
{
    Scene *scene = scene_from_text(
        "camera: {position: [0, 0, 0.9], target: [0, 0, 0], vertical_fov: 60}\n"
        "materials:\n"
        "  - {name: wall, type: diffuse, reflectance: [0.6, 0.6, 0.6]}\n"
        "  - {name: lead, type: glossy, diffuse: [0.2, 0.2, 0.2], specular: [0.5, 0.5, 0.5], exponent: 30}\n"
        "  - {name: tin, type: mirror, reflectance: [0.8, 0.8, 0.8]}\n"
        "  - {name: crown, type: glass, indices: [1.7, 1.7, 1.7]}\n"
        "lights: [{type: point, position: [0, 0.9, 0], power: [1, 1, 1]}]\n"
        "shapes:\n"
        "  - {type: box, low: [-1, -1, -1], high: [1, 1, 1], material: wall}\n"
        "  - {type: sphere, centre: [-0.5, -0.6, 0], radius: 0.3, material: lead}\n"
        "  - {type: sphere, centre: [0.5, -0.6, 0], radius: 0.3, material: tin}\n"
        "  - {type: mesh, file: meshes/diamond.obj, material: crown}\n");
    for (int loop = 0; loop < 2; loop++) {
        PhotonPass pass = photons_of(scene, FEWER(50000), 1, (StepChoice){GLOSSY_PHONG, loop});
        assert_true(pass.rest.count > (size_t)pass.emitted);
        for (size_t i = 0; i < pass.rest.count; i++) {
            Colour power = pass.rest.photons[i].power;
            assert_int_equal(pass.rest.photons[i].colour, WHITE);
            assert_true(power.r == power.g && power.g == power.b);
        }
    }
}

// Without glass the two ways to trace draw the same random numbers in the same order: not only equal
// statistics, but equal photons.
TEST(loop_and_recursion_agree_without_glass)
{
    const char *files[] = {"scenes/box_diffuse.yaml", "scenes/box_glossy.yaml", "scenes/ring.yaml"};
    for (int f = 0; f < 3; f++) {
        Scene *scene = scene_from_file(files[f]);
        for (int glossy = 0; glossy < 2; glossy++) {
            PhotonPass loop = photons_of(scene, 20000, 1, (StepChoice){(GlossyModel)glossy, true});
            PhotonPass recursion = photons_of(scene, 20000, 1, (StepChoice){(GlossyModel)glossy, false});
            assert_true(loop.rest.count > 1000);
            assert_int_equal(loop.rest.count, recursion.rest.count);
            assert_memory_equal(loop.rest.photons, recursion.rest.photons, loop.rest.count * sizeof(StoredPhoton));
        }
    }
}
