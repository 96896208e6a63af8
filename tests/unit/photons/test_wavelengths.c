// Photons of single wavelengths: white stays white, and a prism bends each as Snell's law has it.
#include "unit/test_common.h"

#define PLAY_WAVELENGTHS ((StepChoice){GLOSSY_PHONG, LOOP_WAVELENGTH})

static PhotonPass spectral_pass(const Scene *scene, long photons, bool hero)
{
    return pass_of(scene, (PhotonPassOptions){.photons = photons, .seed = 1, .play = PLAY_WAVELENGTHS, .hero = hero});
}

static void flux_of(const PhotonPass *pass, double flux[3])
{
    for (int c = 0; c < 3; c++)
        flux[c] = 0.0;
    for (size_t i = 0; i < pass->rest.count; i++)
        for (int c = 0; c < 3; c++)
            flux[c] += (double)colour_channel(pass->rest.photons[i].power, c);
}

TEST(a_grey_box_stays_white)
{
    Scene *scene = scene_from_text("camera: {position: [0, 0, 0.9], target: [0, 0, 0], vertical_fov: 60}\n"
                                   "materials: [{name: grey, type: diffuse, reflectance: [0.5, 0.5, 0.5]}]\n"
                                   "lights: [{type: sphere, centre: [0, 0, 0], radius: 0.2, power: [1, 1, 1]}]\n"
                                   "shapes: [{type: box, low: [-1, -1, -1], high: [1, 1, 1], material: grey}]\n");
    for (int hero = 0; hero < 2; hero++) {
        PhotonPass pass = spectral_pass(scene, FEWER(400000), hero);
        double flux[3];
        flux_of(&pass, flux);
        double mean = (flux[0] + flux[1] + flux[2]) / 3.0;
        for (int c = 0; c < 3; c++)
            assert_within(flux[c] / mean, 1.0, 0.003 * sqrt(4e5 / (double)pass.emitted), "a channel over the mean");
        assert_within(mean, 1.9, 0.1, "W that land, of 1 W; the lamp takes some");
    }
}

// Behind four panes that disperse, but hardly reflect, every wavelength flies as before, and carries what the eight faces let through.
TEST(panes_stay_white)
{
    Scene *scene = scene_from_text(
        "camera: {position: [0, 0, 4], target: [0, 0, 0], vertical_fov: 60}\n"
        "render: {depth: 9}\n"
        "materials: [{name: black, type: diffuse, reflectance: [0, 0, 0]}, {name: white, type: diffuse, "
        "reflectance: [1, 1, 1]}, {name: flint, type: glass, index_d: 1.1, abbe: 10}]\n"
        "lights: [{type: beam, position: [0, 0, 2], target: [0.5, 0, 0], radius: 0.01, power: [1, 1, 1]}]\n"
        "shapes:\n"
        "  - {type: box, low: [-5, -5, 1.4], high: [5, 5, 1.5], material: flint}\n"
        "  - {type: box, low: [-5, -5, 1.0], high: [5, 5, 1.1], material: flint}\n"
        "  - {type: box, low: [-5, -5, 0.6], high: [5, 5, 0.7], material: flint}\n"
        "  - {type: box, low: [-5, -5, 0.2], high: [5, 5, 0.3], material: flint}\n"
        "  - {type: rectangle, corner: [-9, -9, -1], edge_u: [18, 0, 0], edge_v: [0, 18, 0], material: white}\n");
    PhotonPass pass = spectral_pass(scene, FEWER(300000), false);
    double expected[3] = {0}, flux[3] = {0}, slope = 0.5 / sqrt(4.25);
    for (int i = 0; i < 700; i++) { // straight through: the last of nine surfaces is the screen
        float wavelength = WAVELENGTH_FIRST + ((float)i + 0.5f) * WAVELENGTH_RANGE / 700.0f;
        double index = cauchy_index(1.1, 10.0, (double)wavelength);
        double through = 1.0 - (double)steps.fresnel((float)sqrt(1.0 - slope * slope), (float)(1.0 / index));
        for (int c = 0; c < 3; c++)
            expected[c] += (double)colour_channel(spectral_colour(wavelength), c) * pow(through, 8) / 700.0;
    }
    flux_of(&pass, flux);
    for (size_t i = 0; i < pass.rest.count; i++) {
        Vec3 onward = vec3_negate(stored_photon_wi(&pass.rest.photons[i]));
        assert_true(angle_between(onward, scene->lights[0].direction) < 0.02);
    }
    for (int c = 0; c < 3; c++)
        assert_within(flux[c] / expected[c], flux[1] / expected[1], 0.003 * sqrt(3e5 / (double)pass.emitted),
                      "a channel over what Fresnel lets through");
    assert_within(flux[1] / expected[1], 1.0, 0.01, "all over what Fresnel lets through");
}

// A 60° prism, met at 63.5935°: D = i + asin(n sin(60° − asin(sin i/n))) − 60°.
static double deviation_of(double index)
{
    double i = 63.5935 / DEGREES, inside = 60.0 / DEGREES - asin(sin(i) / index);
    return 63.5935 + asin(index * sin(inside)) * DEGREES - 60.0;
}

static void check_deviation(const char *glass, double wavelength, double index)
{
    double turn = (30.0 - 63.5935) / DEGREES;
    Scene *scene = scene_from_text(
        words("camera: {position: [0, 0.5, 0.001], target: [0, 0, 0], vertical_fov: 40}\n"
              "materials:\n"
              "  - {name: grey, type: diffuse, reflectance: [0.5, 0.5, 0.5]}\n"
              "  - {name: flint, type: glass, %s}\n"
              "lights: [{type: beam, spectrum: '%g', position: [%.7f, 0, %.7f], target: [-0.015, 0, 0], radius: 0.001, "
              "power: [1, 1, 1]}]\n"
              "shapes:\n"
              "  - {type: prism, apex: [0, 0, -0.025981], axis: [0, 1, 0], down: [0, 0, 1], angle: 60, side: 0.06, "
              "length: 0.08, material: flint}\n"
              "  - {type: sphere, centre: [0, 0, 0], radius: 1, material: grey}\n",
              glass, wavelength, -0.015 - 0.3 * cos(turn), -0.3 * sin(turn)));
    PhotonPass pass = spectral_pass(scene, 2000, false);
    long seen = 0;
    for (size_t i = 0; i < pass.rest.count; i++) {
        const StoredPhoton *photon = &pass.rest.photons[i];
        if (photon->path != PATH_CAUSTIC || photon->bounce != 2)
            continue;
        double found = angle_between(scene->lights[0].direction, vec3_negate(stored_photon_wi(photon)));
        assert_within(found, deviation_of(index), 0.05, "deviation of a wavelength, degrees");
        assert_within((double)wavelength_of_band(photon->colour), wavelength, 0.8, "the wavelength that is kept");
        seen++;
    }
    assert_true(seen > 1000);
    free_all(NULL);
}

TEST(a_prism_bends_ten_wavelengths_by_snells_law)
{
    static const double wavelengths[10] = {385, 420, 450, 486.1, 520, 550, 589.3, 632.8, 680, 725};
    for (int i = 0; i < 10; i++) {
        check_deviation("glass: N-SF11", wavelengths[i], glass_index(glass_find("N-SF11"), wavelengths[i]));
        check_deviation("index_d: 1.7, abbe: 30", wavelengths[i], cauchy_index(1.7, 30, wavelengths[i]));
    }
}

// Three indices: their wavelengths are bent by them, nearly.
TEST(three_indices_lie_on_a_curve)
{
    double a, b;
    cauchy_through((const float[3]){1.78133f, 1.79132f, 1.81369f}, &a, &b);
    assert_within(a + b * 1e6 / (WAVELENGTH_GREEN * WAVELENGTH_GREEN), 1.79132, 0.001, "green of N-SF11");
    cauchy_through((const float[3]){1.5f, 1.5f, 1.5f}, &a, &b);
    assert_true(fabs(a - 1.5) < 1e-6 && fabs(b) < 1e-6);
}
