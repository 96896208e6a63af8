// Physics by the book, through real photon tracing: the prism and the rainbow. The ring: test_ring.c.
#include "unit/test_common.h"

// A 60° prism of N-SF11 inside a black sphere; a beam meets the middle of its left face at `incidence`
// degrees to that face's normal. The prism stands along y; its base, at z > 0, is what light is bent towards.
static Scene *prism_scene(double incidence)
{
    double turn = (30.0 - incidence) / DEGREES; // the face's normal, inwards, lies at 30° to +x
    return scene_from_text(
        words("camera: {position: [0, 0.5, 0.001], target: [0, 0, 0], vertical_fov: 40}\n"
              "render: {depth: 200}\n"
              "materials:\n"
              "  - {name: black, type: diffuse, reflectance: [0, 0, 0]}\n"
              "  - {name: flint, type: glass, glass: N-SF11}\n"
              "lights:\n"
              "  - {type: beam, position: [%.7f, 0, %.7f], target: [-0.015, 0, 0], radius: 0.001, power: [1, 1, 1]}\n"
              "shapes:\n"
              "  - {type: prism, apex: [0, 0, -0.025981], axis: [0, 1, 0], down: [0, 0, 1], angle: 60, side: 0.06, "
              "length: 0.08, material: flint}\n"
              "  - {type: sphere, centre: [0, 0, 0], radius: 1, material: black}\n",
              -0.015 - 0.3 * cos(turn), -0.3 * sin(turn)));
}

// Share of unpolarised light that gets through one face: Fresnel's formulas with angles (radians) instead of indices.
static double through_face(double i, double r)
{
    double s = sin(i - r) / sin(i + r), p = tan(i - r) / tan(i + r);
    return 1.0 - 0.5 * (s * s + p * p);
}

// Photons that left the prism after exactly two refractions turn by expected[0…2] degrees (red, green, blue);
// NAN: total reflection lets none of that colour leave. Gives the flux of each colour that left so, as a
// share of the beam's.
static void check_deviations(const Scene *scene, const double expected[3], Mean share[3])
{
    const Light *beam = &scene->lights[0];
    PhotonPass pass = photons_of(scene, FEWER(20000), 1, PLAY_DEFAULT);
    for (int c = 0; c < 3; c++)
        share[c] = (Mean){0};
    for (size_t i = 0; i < pass.rest.count; i++) {
        const StoredPhoton *photon = &pass.rest.photons[i];
        if (photon->path != PATH_CAUSTIC || photon->bounce != 2)
            continue;
        assert_int_not_equal(photon->colour, WHITE);
        int c = photon->colour - RED;
        double deviation = angle_between(beam->direction, vec3_negate(stored_photon_wi(photon)));
        if (isnan(expected[c]))
            fail_msg("colour %d should be totally reflected, but leaves at %g degrees", c, deviation);
        assert_within(deviation, expected[c], 0.05, "deviation of a photon, degrees");
        mean_add(&share[c], (double)pass.emitted * (double)(colour_channel(photon->power, c) / beam->power.r));
    }
    for (int c = 0; c < 3; c++)
        share[c].count = pass.emitted; // those that went elsewhere count as 0
}

// In a scene with nothing but the prism, its two faces alone decide how much gets through.
static void check_prism(double incidence, const double expected[3])
{
    const double index[3] = {1.78133, 1.79132, 1.81369};
    Mean share[3];
    Scene *scene = prism_scene(incidence);
    check_deviations(scene, expected, share);
    for (int c = 0; c < 3; c++) {
        double i1 = incidence / DEGREES, r1 = asin(sin(i1) / index[c]);
        double r2 = 60.0 / DEGREES - r1, i2 = asin(index[c] * sin(r2));
        double through = isnan(expected[c]) ? 0.0 : through_face(i1, r1) * through_face(i2, r2);
        assert_mean(&share[c], through, "share that gets through");
    }
}

// D = i1 + i2 − A with sin r1 = sin i1/n, r2 = A − r1, sin i2 = n·sin r2; n = 1.78133, 1.79132, 1.81369
// (Schott's Sellmeier coefficients at 611.28, 549.13, 464.31 nm). At 63.5935° green goes through
// symmetrically: its least deviation.
TEST(prism_splits_white_light)
{
    check_prism(63.5935, (double[]){65.926, 67.187, 70.226});
}

TEST(prism_of_the_example_scene)
{
    Mean share[3];
    Scene *scene = scene_from_file("scenes/prism.yaml");
    assert_int_equal(scene->lights[0].type, LIGHT_BEAM);
    scene->light_count = 1; // the lamp beside the beam is switched off
    check_deviations(scene, (double[]){65.926, 67.187, 70.226}, share);
    for (int c = 0; c < 3; c++)
        assert_true(mean_value(&share[c]) > 0.3);
}

// Below i1 = asin(n·sin(A − asin(1/n))) face 2 reflects totally: 50.955° for red, 51.915° green, 54.133° blue.
TEST(prism_lets_only_red_out)
{
    check_prism(51.5, (double[]){75.494, NAN, NAN});
}

// The beginner's black prism: nothing leaves through face 2, but no light is lost either.
TEST(prism_at_45_degrees_reflects_every_colour)
{
    check_prism(45.0, (double[]){NAN, NAN, NAN});
    Scene *scene = prism_scene(45.0);
    PhotonPass pass = photons_of(scene, FEWER(20000), 1, PLAY_DEFAULT);
    long by_colour[4] = {0};
    for (size_t i = 0; i < pass.rest.count; i++)
        by_colour[pass.rest.photons[i].colour] += pass.rest.photons[i].bounce > 2;
    for (int c = 0; c < 3; c++) {
        assert_true(by_colour[RED + c] > (long)pass.emitted / 2);
        assert_within(pass.ledger.absorbed[c], 1.0, 0.02, "power that arrives on the black sphere");
    }
}

// Largest angle from the antisolar point after one reflection inside the drop (3 surfaces met), and least
// after two (4): where the bows stand. In degrees, by colour.
static void bows(const Scene *scene, double primary[4], double secondary[4])
{
    PhotonPass pass = photons_of(scene, FEWER(300000), 1, PLAY_DEFAULT);
    for (int c = 0; c < 4; c++) {
        primary[c] = 0.0;
        secondary[c] = 180.0;
    }
    for (size_t i = 0; i < pass.rest.count; i++) {
        const StoredPhoton *photon = &pass.rest.photons[i];
        if (photon->path != PATH_CAUSTIC)
            continue;
        // The drop is seen where the photon comes from; the antisolar point lies along the beam.
        double radius = angle_between(scene->lights[0].direction, stored_photon_wi(photon));
        if (photon->bounce == 3)
            primary[photon->colour] = fmax(primary[photon->colour], radius);
        if (photon->bounce == 4)
            secondary[photon->colour] = fmin(secondary[photon->colour], radius);
    }
}

// Descartes: primary 4r − 2i at cos i = √((n²−1)/3); secondary 180° + 2i − 6r at cos i = √((n²−1)/8). Water
// at 20 °C (Daimon & Masumura 2007): n = 1.33269, 1.33472, 1.33871 at 611.28, 549.13, 464.31 nm.
TEST(rainbow_of_a_drop_of_water)
{
    const double first[3] = {42.122, 41.829, 41.255}, second[3] = {50.811, 51.340, 52.377};
    double primary[4], secondary[4];
    Scene *scene = scene_from_file("scenes/raindrop.yaml");
    bows(scene, primary, secondary);
    for (int c = 0; c < 3; c++) {
        assert_within(primary[RED + c], first[c], 0.1, "primary rainbow");
        assert_within(secondary[RED + c], second[c], 0.1, "secondary rainbow");
    }
    assert_true(primary[WHITE] == 0.0); // what went in came out coloured
}

// The textbook's two indices, each by itself: glass of one index makes a white bow.
TEST(rainbow_of_textbook_indices)
{
    const double indices[2] = {1.331, 1.343}, first[2] = {42.370, 40.646}, second[2] = {50.365, 53.478};
    for (int i = 0; i < 2; i++) {
        double primary[4], secondary[4];
        Scene *scene = scene_from_file("scenes/raindrop.yaml");
        for (size_t m = 0; m < scene->material_count; m++) {
            Material *material = &scene->materials[m];
            material->disperses = false;
            for (int c = 0; c < 3; c++)
                material->index[c] = (float)indices[i];
        }
        bows(scene, primary, secondary);
        assert_within(primary[WHITE], first[i], 0.1, "primary rainbow");
        assert_within(secondary[WHITE], second[i], 0.1, "secondary rainbow");
        assert_true(primary[RED] == 0.0 && primary[GREEN] == 0.0 && primary[BLUE] == 0.0);
    }
}
