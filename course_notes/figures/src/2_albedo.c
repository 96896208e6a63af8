// How much each version of the glossy bounce sends on, and how bright it looks in a white furnace, for ρ = 1:
// 2_albedo OUT.dat OUT.txt
// OUT.dat, n = 20: block 0: θ (degrees), albedo of "absorbed below" and of modified Phong by the closed forms, share
// that the source text sends into its lobe; block 1: θ, albedo of source text, absorbed, redrawn, Phong by drawing
// 100 000 photons; block 2: θ_o, radiance towards the eye under a sky of radiance 1: source text, redrawn, Phong,
// normalised.
// OUT.txt: the table at n = 100, θ = 80°, and ratios that tell reciprocal from not.
#include "2_lobe.h"

enum { SOURCE_TEXT, ABSORBED, REDRAWN, PHONG, NORMALISED, VERSIONS };
static const char *const version_names[VERSIONS] = {"source", "absorbed", "redrawn", "phong", "normalised"};

// One photon by the steps; returns the weight it goes on with, 0 when it was absorbed.
static double bounce(int version, double n, double theta, double phong_to_one, Rng *rng)
{
    Vec3 mirror, in = arrival(theta, &mirror), up = vec3(0, 0, 1), out;
    float weight = 0.0f;
    if (version == SOURCE_TEXT)
        return steps.scatter_glossy_source_text(in, up, (float)n, rng, &out, &weight) ? (double)weight : 0.0;
    if (version == PHONG)
        return steps.scatter_glossy_phong(in, up, (float)n, rng, &out, &weight) ? (double)weight : 0.0;
    do {
        Vec3 local = steps.sample_lobe((float)n, rng);
        out = steps.turn_to(local, mirror);
        if (version == ABSORBED)
            return out.z > 0.0f;
    } while (out.z <= 0.0f);
    return version == REDRAWN ? 1.0 : phong_to_one * (double)out.z;
}

static double measured_albedo(int version, double n, double theta, long photons)
{
    double phong_to_one = lobe_above(n, theta) / lobe_weighted(n, theta), sum = 0.0;
    Rng rng = rng_create(2, (uint64_t)(1000.0 * n + theta / RADIANS) * VERSIONS + (uint64_t)version);
    for (long i = 0; i < photons; i++)
        sum += bounce(version, n, theta, phong_to_one, &rng);
    return sum / (double)photons;
}

// f of each version without its cosⁿα, for an arrival at theta_i; the source text's is that of its lobe.
static double scale_of_f(int version, double n, double theta_i, double cos_out)
{
    switch (version) {
    case SOURCE_TEXT:
        return 0.5 * (1.0 + cos(theta_i)) / (lobe_above(n, theta_i) * cos_out);
    case ABSORBED:
        return (n + 1.0) / (2.0 * M_PI * cos_out);
    case REDRAWN:
        return 1.0 / (lobe_above(n, theta_i) * cos_out);
    case PHONG:
        return (n + 2.0) / (2.0 * M_PI);
    default:
        return 1.0 / lobe_weighted(n, theta_i);
    }
}

// ∫f(wi → wo) cosθ_i dω_i: every direction of the sky about wo's mirror direction, cells of equal lobe measure.
static void furnace(double n, double theta_o, double brightness[VERSIONS])
{
    enum { RINGS = 300, SECTORS = 120, TABLE = 1000 };
    static double scale[VERSIONS][TABLE + 1]; // over θ_i, at cosθ_o = 1: the rest is the same in every cell
    static bool filled;
    for (int v = 0; v < VERSIONS && !filled; v++)
        for (int i = 0; i <= TABLE; i++)
            scale[v][i] = scale_of_f(v, n, M_PI / 2.0 * i / TABLE, 1.0);
    filled = true;
    double cos_out = cos(theta_o), sin_out = sin(theta_o);
    double cell = 2.0 * M_PI / ((n + 1.0) * RINGS * SECTORS);
    memset(brightness, 0, VERSIONS * sizeof *brightness);
    for (int i = 0; i < RINGS * SECTORS; i++) {
        double cos_alpha = pow((i / SECTORS + 0.5) / RINGS, 1.0 / (n + 1.0));
        double turn = cos(2.0 * M_PI * (i % SECTORS + 0.5) / SECTORS);
        double cos_in = cos_alpha * cos_out + sqrt(1.0 - cos_alpha * cos_alpha) * sin_out * turn;
        if (cos_in <= 0.0)
            continue;
        double x = acos(fmin(cos_in, 1.0)) / (M_PI / 2.0) * TABLE;
        int k = x < TABLE ? (int)x : TABLE - 1;
        for (int v = 0; v < VERSIONS; v++)
            brightness[v] += (scale[v][k] + (scale[v][k + 1] - scale[v][k]) * (x - k)) * cos_in * cell;
    }
    for (int v = SOURCE_TEXT; v <= REDRAWN; v++)
        brightness[v] /= cos_out;
    brightness[SOURCE_TEXT] += 0.5 * (1.0 - cos_out); // what stays diffuse beyond 90°: f = 1/π
}

static void write_curves(FILE *data, double n)
{
    for (int degrees = 0; degrees <= 90; degrees++) {
        double theta = degrees * RADIANS;
        fprintf(data, "%d %.5f %.5f %.5f\n", degrees, (n + 1.0) / (2.0 * M_PI) * lobe_above(n, theta),
                (n + 2.0) / (2.0 * M_PI) * lobe_weighted(n, theta), 0.5 * (1.0 + cos(theta)));
    }
    fprintf(data, "\n\n");
    for (int degrees = 5; degrees < 90; degrees += 10) {
        fprintf(data, "%d", degrees);
        for (int version = SOURCE_TEXT; version <= PHONG; version++)
            fprintf(data, " %.4f", measured_albedo(version, n, degrees * RADIANS, 100000));
        fprintf(data, "\n");
    }
    fprintf(data, "\n\n");
    for (int degrees = 0; degrees < 89; degrees++) {
        double b[VERSIONS];
        furnace(n, degrees * RADIANS, b);
        fprintf(data, "%d %.4f %.4f %.4f %.4f\n", degrees, b[SOURCE_TEXT], b[REDRAWN], b[PHONG], b[NORMALISED]);
    }
}

static void write_numbers(FILE *text)
{
    double at_80 = 80.0 * RADIANS, at_60 = 60.0 * RADIANS;
    double above = lobe_above(100.0, at_80), weighted = lobe_weighted(100.0, at_80);
    const double exact[VERSIONS] = {1.0, 101.0 / (2.0 * M_PI) * above, 1.0, 102.0 / (2.0 * M_PI) * weighted, 1.0};
    for (int v = 0; v < VERSIONS; v++)
        fprintf(text, "%s_80 %.4f\n%s_80_drawn %.3f\n", version_names[v], exact[v], version_names[v],
                measured_albedo(v, 100.0, at_80, 1000000));
    // f(60° → 80°)/f(80° → 60°) at n = 20, in the lobe: cosⁿα is the same both ways.
    for (int v = 0; v < VERSIONS; v++)
        fprintf(text, "%s_reciprocity %.2f\n", version_names[v],
                scale_of_f(v, 20.0, at_60, cos(at_80)) / scale_of_f(v, 20.0, at_80, cos(at_60)));
    fprintf(text, "phong_80_lost_percent %.2f\n", 100.0 * (1.0 - exact[PHONG]));
    fprintf(text, "above_5_60 %.6f\nphong_5_60 %.6f\n", 6.0 / (2.0 * M_PI) * lobe_above(5.0, at_60),
            7.0 / (2.0 * M_PI) * lobe_weighted(5.0, at_60));
    double b[VERSIONS];
    for (int degrees = 0; degrees <= 80; degrees += 40) {
        furnace(20.0, degrees * RADIANS, b);
        for (int v = 0; v < VERSIONS; v++)
            fprintf(text, "%s_furnace_%d %.3f\n", version_names[v], degrees, b[v]);
    }
}

int main(int count, char **names)
{
    FILE *data, *text;
    if (!start_figure(count, names, &data, &text))
        return 1;
    write_curves(data, 20.0);
    write_numbers(text);
    return fclose(data) | fclose(text);
}
