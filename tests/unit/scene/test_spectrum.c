// Lamps' spectra, walls over wavelength, the colour of a wavelength: held against sums of their own.
#include "unit/test_common.h"

#define FINE 7000 // wavelengths of a mean, in the middle of their bins

static float fine_wavelength(int i)
{
    return WAVELENGTH_FIRST + WAVELENGTH_RANGE * ((float)i + 0.5f) / FINE;
}

static void assert_colour(Colour found, double r, double g, double b, double tolerance, const char *what)
{
    const double expected[3] = {r, g, b};
    for (int c = 0; c < 3; c++)
        assert_within((double)colour_channel(found, c), expected[c], tolerance, what);
}

TEST(equal_energy_is_white_and_primaries_come_back)
{
    for (int p = 0; p < 3; p++) {
        double sum[3] = {0}, white[3] = {0};
        Colour wall = colour(p == 0, p == 1, p == 2);
        for (int i = 0; i < FINE; i++) {
            Colour hue = spectral_colour(fine_wavelength(i));
            double share = (double)reflectance_at(wall, fine_wavelength(i));
            for (int c = 0; c < 3; c++) {
                sum[c] += (double)colour_channel(hue, c) * share / FINE;
                white[c] += (double)colour_channel(hue, c) / FINE;
            }
        }
        for (int c = 0; c < 3; c++) {
            assert_within(white[c], 1.0, 2e-5, "equal energy");
            assert_within(sum[c], c == p, 5e-5, "a primary under equal energy");
        }
        assert_colour(spectrum_colour(NULL, colour_grey(1.0f), wall), p == 0, p == 1, p == 2, 2e-4,
                      "by the library's grid");
    }
}

TEST(walls_reflect_between_none_and_all)
{
    for (int i = 0; i < FINE; i += 7)
        for (int p = 0; p < 8; p++) {
            float share = reflectance_at(colour(p & 1, (p & 2) / 2, (p & 4) / 4), fine_wavelength(i));
            assert_true(share >= -1e-6f && share <= 1.000001f);
        }
    assert_within((double)reflectance_at(colour_grey(0.37f), 433.0f), 0.37, 1e-6, "a grey wall is grey everywhere");
}

static Spectrum parsed(const char *words)
{
    Spectrum spectrum;
    const char *why;
    if (!spectrum_parse(words, &spectrum, &why))
        fail_msg("%s: %s", words, why);
    return spectrum;
}

// D65 in linear sRGB is white; in our channels, white by equal energy, it is what one is over the other.
TEST(daylight_has_the_colour_of_d65)
{
    Spectrum daylight = parsed("daylight");
    Colour seen = spectrum_colour(&daylight, colour_grey(1.0f), colour_grey(1.0f));
    double red = (double)(seen.r * EQUAL_ENERGY_RED), green = (double)(seen.g * EQUAL_ENERGY_GREEN),
           blue = (double)(seen.b * EQUAL_ENERGY_BLUE);
    assert_within(red / green, 1.0, 0.01, "red over green of D65 in sRGB"); // the lobes' own error
    assert_within(blue / green, 1.0, 0.01, "blue over green of D65 in sRGB");
}

TEST(spectra_from_words)
{
    Spectrum sodium = parsed("sodium"), line = parsed("632.8"), pairs = parsed("380 1, 555 1,730 3");
    assert_within((double)sodium.line, 589.3, 1e-3, "sodium's line");
    assert_within((double)line.line, 632.8, 1e-3, "a line");
    assert_true(pairs.line == 0.0f);
    assert_within((double)spectrum_at(&pairs, 730.0f) / (double)spectrum_at(&pairs, 400.0f), 3.0, 1e-5,
                  "a ramp's ends");
    assert_within((double)spectrum_at(&pairs, 642.5f) / (double)spectrum_at(&pairs, 400.0f), 2.0, 1e-5,
                  "a ramp's middle");
    assert_within((double)spectrum_at(&pairs, 400.0f), 1.0 / 1.5, 1e-4, "its mean is 1");
    static const char *const wrong[] = {"",
                                        "candle",
                                        "300",
                                        "731",
                                        "500 1",
                                        "500 1 600",
                                        "600 1, 500 1",
                                        "500 -1, 600 1",
                                        "500 0, 600 0",
                                        "500 1, 600 1;",
                                        "800 1, 900 1",
                                        "nan",
                                        "sodium lamp"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        const char *why = NULL;
        if (spectrum_parse(wrong[i], &line, &why) || !why)
            fail_msg("'%s' passes for a spectrum", wrong[i]);
    }
}

// A lamp's light behind a filter has the filtered mean's colour, and a line's has one hue on every wall.
TEST(lamps_by_wavelength)
{
    Scene *scene = scene_from_text("camera: {position: [0, 0, 1], target: [0, 0, 0], vertical_fov: 40}\n"
                                   "lights:\n"
                                   "  - {type: point, position: [0, 0, 0], power: [3, 2, 1]}\n"
                                   "  - {type: point, position: [0, 0, 0], power: [2, 2, 2], spectrum: sodium}\n"
                                   "  - {type: rectangle, corner: [0, 0, 0], edge_u: [1, 0, 0], edge_v: [0, 1, 0], "
                                   "radiance: [2, 2, 2], spectrum: daylight}\n"
                                   "shapes: []\n");
    const Light *lights = scene->lights;
    double mean = 0.0;
    for (int i = 0; i < FINE; i++)
        mean += (double)light_power_at(&lights[0], fine_wavelength(i)) / FINE;
    assert_true(mean > 1.0 && mean < 3.0);
    assert_colour(light_reflected(&lights[0], colour_grey(1.0f), 1.0f), 3, 2, 1, 1e-3, "a coloured lamp on white");
    Colour red = light_reflected(&lights[1], colour(0.8f, 0.1f, 0.1f), 1.0f);
    Colour green = light_reflected(&lights[1], colour(0.1f, 0.8f, 0.1f), 1.0f), hue = spectral_colour(589.3f);
    assert_within((double)(red.g / red.r), (double)(hue.g / hue.r), 1e-5, "sodium light on red");
    assert_within((double)(green.g / green.r), (double)(hue.g / hue.r), 1e-5, "sodium light on green");
    assert_colour(colour_sub(lights[2].radiance, light_reflected(&lights[2], colour_grey(1.0f), 1.0f)), 0, 0, 0, 1e-3,
                  "with and without wavelengths, daylight has one colour");
}
