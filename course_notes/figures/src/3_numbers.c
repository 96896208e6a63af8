// The numbers that chapter 3 quotes, computed by the reference steps: 3_numbers [FILE], lines of "key value".
#include "3_prism.h"

#include <string.h>

static const double bands[3] = {WAVELENGTH_RED, WAVELENGTH_GREEN, WAVELENGTH_BLUE};
static const char *const band_names[3] = {"red", "green", "blue"};

// What step 3.3 is given: the glass of a scene file.
static Material glass_material(const char *name)
{
    Material glass = {.type = MATERIAL_GLASS, .disperses = true};
    for (int c = 0; c < 3; c++)
        glass.index[c] = (float)index_of(name, bands[c]);
    return glass;
}

static double index_step(const char *name, int channel)
{
    Material glass = glass_material(name);
    return (double)steps.refractive_index(&glass, (PhotonColour)(RED + channel));
}

static double mean_index(const char *name)
{
    Material glass = glass_material(name);
    return (double)steps.refractive_index(&glass, WHITE);
}

static double reflected(double degrees, double eta)
{
    return (double)steps.fresnel((float)cos(degrees / DEGREES), (float)eta);
}

static void print_glasses(FILE *out)
{
    static const char *const names[] = {"water_20C", "fused_silica", "N-BK7", "SF10", "N-SF11", "diamond"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        for (int c = 0; c < 3; c++)
            fprintf(out, "n_%s_%s %.5f\n", names[i], band_names[c], index_step(names[i], c));
        double n_d = index_of(names[i], 587.562);
        double spread = index_of(names[i], 486.133) - index_of(names[i], 656.273);
        fprintf(out, "abbe_%s %.2f\n", names[i], (n_d - 1.0) / spread);
        fprintf(out, "spread_%s %.4f\n", names[i], spread);
        fprintf(out, "mean_%s %.5f\n", names[i], mean_index(names[i]));
    }
    for (int i = 0; i < 3; i++)
        fprintf(out, "resonance_%d_N-SF11 %.3f\n", i + 1, sqrt(glass_find("N-SF11")->c[i]));
    double worst = 0.0;
    double n_d = index_of("N-SF11", 587.562);
    double abbe = (n_d - 1.0) / (index_of("N-SF11", 486.133) - index_of("N-SF11", 656.273));
    for (int nm = 435; nm <= 700; nm++)
        worst = fmax(worst, fabs(cauchy_index(n_d, abbe, nm) - index_of("N-SF11", nm)));
    const SellmeierGlass *glass = glass_find("N-SF11"); // Sellmeier's terms as series, the first members alone
    double a = 1.0 + glass->b[0] + glass->b[1];
    fprintf(out, "infrared_N-SF11 %.4f\n", -glass->b[2] * 0.587562 * 0.587562 / glass->c[2]);
    fprintf(out, "series_A_N-SF11 %.3f\n", sqrt(a));
    fprintf(out, "series_B_N-SF11 %.4f\n", 0.5 * (glass->b[0] * glass->c[0] + glass->b[1] * glass->c[1]) / sqrt(a));
    fprintf(out, "cauchy_error_N-SF11 %.5f\n", worst);
    fprintf(out, "cauchy_A_N-SF11 %.4f\n", cauchy_index(n_d, abbe, 1e9));
    fprintf(out, "cauchy_B_N-SF11 %.4f\n", (cauchy_index(n_d, abbe, 1e3) - cauchy_index(n_d, abbe, 1e9)));
}

static void print_fresnel(FILE *out)
{
    fprintf(out, "normal_1.5 %.4f\n", reflected(0.0, 1.0 / 1.5));
    fprintf(out, "normal_1.5_inside %.4f\n", reflected(0.0, 1.5));
    fprintf(out, "normal_diamond %.3f\n", reflected(0.0, 1.0 / index_of("diamond", WAVELENGTH_GREEN)));
    fprintf(out, "at60_1.5 %.3f\n", reflected(60.0, 1.0 / 1.5));
    fprintf(out, "at80_1.5 %.3f\n", reflected(80.0, 1.0 / 1.5));
    fprintf(out, "critical_1.5 %.2f\n", DEGREES * asin(1.0 / 1.5));
    fprintf(out, "brewster_1.5 %.2f\n", DEGREES * atan(1.5));
    fprintf(out, "at_brewster_1.5 %.4f\n", reflected(DEGREES * atan(1.5), 1.0 / 1.5));
    fprintf(out, "critical_diamond %.1f\n", DEGREES * asin(1.0 / index_of("diamond", WAVELENGTH_GREEN)));
    for (int c = 0; c < 3; c++)
        fprintf(out, "critical_N-SF11_%s %.3f\n", band_names[c], DEGREES * asin(1.0 / index_step("N-SF11", c)));
    fprintf(out, "critical_N-SF11_mean %.3f\n", DEGREES * asin(1.0 / mean_index("N-SF11")));
}

// White light inside N-SF11 at 33.95°: the shares of the channels, their mean, and what the mean index would say.
static void print_choice(FILE *out)
{
    double sum = 0.0;
    for (int c = 0; c < 3; c++) {
        double share = reflected(33.95, index_step("N-SF11", c));
        sum += share / 3.0;
        fprintf(out, "choice_%s %.3f\n", band_names[c], share);
    }
    fprintf(out, "choice_mean %.3f\n", sum);
    fprintf(out, "choice_weight_red %.3f\n", reflected(33.95, index_step("N-SF11", 0)) / sum);
    fprintf(out, "choice_weight_blue %.3f\n", 1.0 / sum);
    fprintf(out, "choice_through_red %.2f\n", (1.0 - reflected(33.95, index_step("N-SF11", 0))) / (1.0 - sum));
    fprintf(out, "choice_lost_percent %.1f\n", 100.0 * (1.0 - reflected(33.95, index_step("N-SF11", 0))));
    fprintf(out, "choice_at_mean_index %.3f\n", reflected(33.95, mean_index("N-SF11")));
}

static void print_prism(FILE *out)
{
    for (int c = 0; c < 3; c++) {
        double n = index_step("N-SF11", c);
        const char *name = band_names[c];
        double best = prism_best_incidence(n);
        fprintf(out, "best_incidence_%s %.4f\n", name, best);
        fprintf(out, "d_min_%s %.3f\n", name, prism_deviation(n, best));
        fprintf(out, "cut_%s %.3f\n", name, prism_cut(n));
        fprintf(out, "second_incidence_45_%s %.2f\n", name, prism_second_incidence(n, 45.0));
        fprintf(out, "d_63.5935_%s %.3f\n", name, prism_deviation(n, 63.5935));
        fprintf(out, "d_45_%s %.3f\n", name, prism_deviation(n, 45.0));
        fprintf(out, "d_51.5_%s %.3f\n", name, prism_deviation(n, 51.5));
        Vec3 turned = steps.reflect(prism_inside(n, 45.0), at_angle(FACE_RIGHT)), down;
        if (steps.refract(turned, vec3_negate(at_angle(FACE_BASE)), (float)n, &down))
            fprintf(out, "base_exit_45_%s %.3f\n", name, angle_between(down, at_angle(FACE_BASE)));
        double middle = prism_deviation(index_step("N-SF11", 1), 63.5935);
        fprintf(out, "screen_mm_%s %.2f\n", name, 500.0 * tan(fabs(prism_deviation(n, 63.5935) - middle) / DEGREES));
    }
}

// The bow's angle for a ray that meets a drop at `incidence` and is reflected `times` times inside.
static double bow_angle(double index, double incidence, int times)
{
    Vec3 inside;
    if (!steps.refract(at_angle(180.0), at_angle(incidence), (float)(1.0 / index), &inside))
        return (double)NAN;
    double r = angle_between(inside, vec3_negate(at_angle(incidence)));
    return times == 1 ? 4.0 * r - 2.0 * incidence : 180.0 + 2.0 * incidence - 6.0 * r;
}

// What share of light comes out of a drop in its bow, where it is reflected `times` times inside: s and p each followed
// by itself (`polarised`), or the mean of both taken at each surface.
static double bow_share(double n, int times, bool polarised)
{
    double cos_i = sqrt((n * n - 1.0) / (times == 1 ? 3.0 : 8.0));
    double cos_r = sqrt(1.0 - (1.0 - cos_i * cos_i) / (n * n));
    double s = pow((cos_i - n * cos_r) / (cos_i + n * cos_r), 2.0);
    double p = pow((n * cos_i - cos_r) / (n * cos_i + cos_r), 2.0);
    double mean = 0.5 * (s + p);
    if (!polarised)
        return pow(1.0 - mean, 2.0) * pow(mean, times);
    return 0.5 * (pow(1.0 - s, 2.0) * pow(s, times) + pow(1.0 - p, 2.0) * pow(p, times));
}

static void print_polarisation(FILE *out)
{
    double green = index_step("water_20C", 1);
    fprintf(out, "bow_true %.4f\nbow_mean %.4f\n", bow_share(green, 1, true), bow_share(green, 1, false));
    for (int c = 0; c < 3; c++) {
        double n = index_step("water_20C", c);
        fprintf(out, "bow_excess_percent_%s %.1f\n", band_names[c],
                100.0 * (bow_share(n, 1, false) / bow_share(n, 1, true) - 1.0));
        fprintf(out, "second_bow_lack_percent_%s %.1f\n", band_names[c],
                100.0 * (1.0 - bow_share(n, 2, false) / bow_share(n, 2, true)));
    }
}

static void print_bows(FILE *out)
{
    for (int c = 0; c < 3; c++) {
        double n = index_step("water_20C", c), primary = 0.0, secondary = 180.0, at = 0.0;
        for (double incidence = 0.01; incidence < 90.0; incidence += 0.01) {
            if (bow_angle(n, incidence, 1) > primary)
                at = incidence;
            primary = fmax(primary, bow_angle(n, incidence, 1));
            secondary = fmin(secondary, bow_angle(n, incidence, 2));
        }
        fprintf(out, "primary_%s %.3f\n", band_names[c], primary);
        fprintf(out, "primary_incidence_%s %.0f\n", band_names[c], at);
        fprintf(out, "secondary_%s %.3f\n", band_names[c], secondary);
    }
}

// The mistake of drawing a colour at each surface: in by one index, out by another, through a pane with parallel faces.
static void print_pane(FILE *out)
{
    for (int in = 0; in < 3; in++)
        for (int leave = 0; leave < 3; leave++) {
            Vec3 inside, beyond;
            Vec3 facing = at_angle(180.0);
            if (!steps.refract(at_angle(60.0), facing, (float)(1.0 / index_step("N-SF11", in)), &inside) ||
                !steps.refract(inside, facing, (float)index_step("N-SF11", leave), &beyond))
                continue;
            fprintf(out, "pane_%s_%s %.2f\n", band_names[in], band_names[leave], angle_between(beyond, at_angle(0.0)));
        }
}

int main(int count, char **arguments)
{
    load_reference_steps();
    FILE *out = open_output(count, arguments);
    print_glasses(out);
    print_fresnel(out);
    print_choice(out);
    print_prism(out);
    print_bows(out);
    print_polarisation(out);
    print_pane(out);
    return fclose(out) == 0 ? 0 : 1;
}
