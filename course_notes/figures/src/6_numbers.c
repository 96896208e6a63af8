// Curves over wavelength and the numbers that chapter 6 quotes, by the reference steps and the library.
//   6_numbers DATA NUMBERS
// DATA, a row a nm: nm, CIE 1931 x y z, red green blue of step 6.3, density of step 6.2 times the range, what a red, a green and a
// blue wall reflect. NUMBERS: lines of "key value".
#include "3_matching.h"
#include "3_prism.h"

#define SODIUM 589.3f

static FILE *numbers;

static double weight_at(double u, double *nm)
{
    float weight;
    *nm = (double)steps.draw_wavelength((float)u, &weight);
    return (double)weight;
}

static void write_curves(FILE *data)
{
    for (int i = 0; i <= 1000; i++) { // at even steps of u, so that the density needs no formula of its own
        double nm, xyz[3], weight = weight_at(i < 1000 ? i / 1000.0 : 1.0 - 0x1p-24, &nm);
        Colour hue = steps.wavelength_colour((float)nm);
        matching_xyz(nm, xyz);
        fprintf(data, "%.3f %.5f %.5f %.5f %.5f %.5f %.5f %.5f", nm, xyz[0], xyz[1], xyz[2], (double)hue.r,
                (double)hue.g, (double)hue.b, 1.0 / weight);
        for (int c = 0; c < 3; c++) {
            Colour wall = colour_grey(0.0f);
            colour_set_channel(&wall, c, 1.0f);
            fprintf(data, " %.5f", (double)reflectance_at(wall, (float)nm));
        }
        fprintf(data, "\n");
    }
}

// Means of step 6.3 over the range: as it is, and with each wavelength cut at 0; where red is lowest; and the mean square with even
// and with drawn wavelengths, which is the noise of one photon.
static void write_colours(void)
{
    double mean[3] = {0}, cut[3] = {0}, even[3] = {0}, drawn[3] = {0}, low = 0.0, low_at = 0.0;
    enum { MANY = 350000 };
    for (int i = 0; i < MANY; i++) {
        double u = (i + 0.5) / MANY, at, nm = (double)WAVELENGTH_FIRST + u * (double)WAVELENGTH_RANGE;
        Colour hue = steps.wavelength_colour((float)nm);
        double weight = weight_at(u, &at);
        Colour hit = steps.wavelength_colour((float)at);
        for (int c = 0; c < 3; c++) {
            double value = (double)colour_channel(hue, c), other = weight * (double)colour_channel(hit, c);
            mean[c] += value / MANY;
            cut[c] += fmax(value, 0.0) / MANY;
            even[c] += value * value / MANY;
            drawn[c] += other * other / MANY;
        }
        if ((double)hue.r < low) {
            low = (double)hue.r;
            low_at = nm;
        }
    }
    for (int c = 0; c < 3; c++) {
        fprintf(numbers, "mean_%c %.4f\n", "rgb"[c], mean[c]);
        fprintf(numbers, "cut_%c %.3f\n", "rgb"[c], cut[c]);
        fprintf(numbers, "variance_ratio_%c %.3f\n", "rgb"[c], (even[c] - 1.0) / (drawn[c] - 1.0));
    }
    fprintf(numbers, "low_red %.2f\nlow_red_nm %.0f\n", low, low_at);
    static const double white[3] = {1.0, 1.0, 1.0};
    double rgb[3];
    xyz_to_srgb(white, rgb);
    for (int c = 0; c < 3; c++)
        fprintf(numbers, "equal_energy_%c %.4f\n", "rgb"[c], rgb[c]);
    for (int nm = 360, c = 0; c < 3; c++, nm = 360) {
        double sum = 0.0, xyz[3];
        for (; nm <= 830; nm++) {
            matching_xyz(nm, xyz);
            sum += xyz[c];
        }
        fprintf(numbers, "integral_%c %.1f\n", "xyz"[c], sum);
    }
}

// How many per cent of the photons lie below and above these wavelengths, drawn and even; weights.
static void write_density(void)
{
    enum { MANY = 100000 };
    double nm, below = 0.0, above = 0.0;
    for (int i = 0; i < MANY; i++) {
        weight_at((i + 0.5) / MANY, &nm);
        below += nm < 420.0;
        above += nm > 680.0;
    }
    fprintf(numbers, "below_420 %.1f\nabove_680 %.1f\n", below * 100.0 / MANY, above * 100.0 / MANY);
    fprintf(numbers, "even_420 %.1f\neven_680 %.1f\n", 4000.0 / 350.0, 5000.0 / 350.0);
    fprintf(numbers, "weight_first %.2f\n", weight_at(0.0, &nm));
    fprintf(numbers, "weight_last %.2f\n", weight_at(1.0 - 0x1p-24, &nm));
    double least = 10.0;
    for (int i = 0; i < MANY; i++)
        least = fmin(least, weight_at((i + 0.5) / MANY, &nm));
    fprintf(numbers, "weight_least %.3f\n", least);
    double xyz[3]; // were they drawn by y
    matching_xyz(430.0, xyz);
    fprintf(numbers, "y_430 %.4f\nweight_by_y_430 %.1f\n", xyz[1], 106.9 / (350.0 * xyz[1]));
}

static double step_index(const SellmeierGlass *glass, double nm)
{
    Material material = {.type = MATERIAL_GLASS, .disperses = true, .sellmeier = glass};
    return (double)steps.index_at_wavelength(&material, (float)nm);
}

// The index with all terms, without the infrared one (that of the largest c), and by Cauchy's formula.
static void write_index(const char *name)
{
    const SellmeierGlass *glass = glass_find(name);
    SellmeierGlass bare = *glass;
    int infrared = 0;
    for (int i = 1; i < SELLMEIER_TERMS; i++)
        infrared = glass->c[i] > glass->c[infrared] ? i : infrared;
    bare.b[infrared] = 0.0;
    static const int places[] = {400, 550, 700};
    double a, b, n_d = step_index(glass, 587.562);
    cauchy_coefficients(n_d, (n_d - 1.0) / (step_index(glass, 486.133) - step_index(glass, 656.273)), &a, &b);
    Material cauchy = {.type = MATERIAL_GLASS, .disperses = true, .cauchy = {(float)a, (float)b}};
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
        double n = step_index(glass, places[i]);
        fprintf(numbers, "n_%s_%d %.5f\n", name, places[i], n);
        fprintf(numbers, "infrared_%s_%d %.5f\n", name, places[i], n - step_index(&bare, places[i]));
        fprintf(numbers, "cauchy_%s_%d %.5f\n", name, places[i],
                (double)steps.index_at_wavelength(&cauchy, (float)places[i]) - n);
    }
    double spread = step_index(glass, 400) - step_index(glass, 700),
           less = step_index(&bare, 400) - step_index(&bare, 700);
    fprintf(numbers, "spread_%s %.5f\n", name, spread);
    fprintf(numbers, "spread_lacks_percent_%s %.1f\n", name, 100.0 * (1.0 - less / spread));
    fprintf(numbers, "nanometres_%s %.3f\n", name, step_index(glass, 550e3));
}

// ° from the point opposite the sun, one reflection inside.
static double primary_bow(double n)
{
    double i = acos(sqrt((n * n - 1.0) / 3.0));
    return (4.0 * asin(sin(i) / n) - 2.0 * i) * DEGREES;
}

static void write_geometry(void)
{
    const SellmeierGlass *flint = glass_find("N-SF11"), *water = glass_find("water_20C");
    double least = prism_deviation(step_index(flint, WAVELENGTH_GREEN), 63.5935);
    static const double ends[] = {400.0, WAVELENGTH_BLUE, WAVELENGTH_RED, 700.0};
    for (int i = 0; i < 4; i++) {
        fprintf(numbers, "screen_mm_%.0f %.2f\n", ends[i],
                500.0 * tan((prism_deviation(step_index(flint, ends[i]), 63.5935) - least) / DEGREES));
        fprintf(numbers, "bow_%.0f %.2f\n", ends[i], primary_bow(step_index(water, ends[i])));
    }
    double slant = sin(60.0 / DEGREES), in = step_index(flint, 400), out = step_index(flint, 700);
    fprintf(numbers, "pane_violet_red %.1f\n", asin(slant * out / in) * DEGREES);
    fprintf(numbers, "pane_red_violet %.1f\n", asin(slant * in / out) * DEGREES);
}

static void write_lamps(void)
{
    Spectrum spectrum;
    const char *why;
    if (!spectrum_parse("daylight", &spectrum, &why))
        exit(1);
    Colour day = spectrum_colour(&spectrum, colour_grey(1.0f), colour_grey(1.0f));
    fprintf(numbers, "daylight_r %.3f\ndaylight_g %.3f\ndaylight_b %.3f\n", (double)day.r, (double)day.g,
            (double)day.b);
    Colour hue = steps.wavelength_colour(SODIUM);
    fprintf(numbers, "sodium_r %.2f\nsodium_g %.2f\nsodium_b %.2f\n", (double)hue.r, (double)hue.g, (double)hue.b);
    // The walls and balls of scenes/sodium.yaml.
    static const struct {
        const char *name;
        Colour colour;
    } things[] = {{"white", {0.74f, 0.74f, 0.74f}}, {"red", {0.66f, 0.20f, 0.16f}},  {"yellow", {0.78f, 0.68f, 0.16f}},
                  {"green", {0.20f, 0.50f, 0.22f}}, {"blue", {0.14f, 0.22f, 0.62f}}, {"violet", {0.42f, 0.16f, 0.55f}}};
    for (size_t i = 0; i < sizeof things / sizeof things[0]; i++)
        fprintf(numbers, "at_sodium_%s %.2f\n", things[i].name, (double)reflectance_at(things[i].colour, SODIUM));
}

int main(int count, char **arguments)
{
    FILE *data = count == 3 ? fopen(arguments[1], "w") : NULL;
    numbers = count == 3 ? fopen(arguments[2], "w") : NULL;
    if (!data || !numbers)
        return fprintf(stderr, "usage: 6_numbers DATA NUMBERS, both writable\n"), 2;
    load_reference_steps();
    write_curves(data);
    write_colours();
    write_density();
    write_index("N-SF11");
    write_index("water_20C");
    write_geometry();
    write_lamps();
    return fclose(data) == 0 && fclose(numbers) == 0 ? 0 : 1;
}
