// What step 2.3 samples, in the plane of incidence: 2_gap OUT.dat OUT.txt
// OUT.dat: angle to the normal (degrees, positive on the mirror's side), measured density in 1/sr, density by the
// formula, for n = 10 at θ = 60°. OUT.txt: shares that leak, and how far the measurement is from the formula.
#include "2_lobe.h"

enum { SAMPLES = 4000000, CELLS = 60 };
static const double exponent = 10.0, sideways = 3.0 * RADIANS; // directions this near to the plane are counted

static double density(double cos_alpha, double cos_out, double theta, double above)
{
    double lobe_share = 0.5 * (1.0 + cos(theta));
    return cos_alpha > 0.0 ? lobe_share * pow(cos_alpha, exponent) / above : cos_out / M_PI;
}

// The formula's mean over a cell, by midpoints: angle `psi` in the plane, `b` sideways.
static double cell_mean(int cell, double theta, double above)
{
    enum { FINE = 20 };
    double sum = 0.0;
    for (int i = 0; i < FINE * FINE; i++) {
        double psi = (-90.0 + 3.0 * (cell + (i % FINE + 0.5) / FINE)) * RADIANS;
        double b = asin(sin(sideways) * (2.0 * (i / FINE + 0.5) / FINE - 1.0));
        sum += density(cos(b) * cos(psi - theta), cos(b) * cos(psi), theta, above);
    }
    return sum / (FINE * FINE);
}

static void write_slice(FILE *data, FILE *text)
{
    static long cells[CELLS];
    double theta = 60.0 * RADIANS, above = lobe_above(exponent, theta);
    Vec3 mirror, in = arrival(theta, &mirror);
    Rng rng = rng_create(2, 60);
    for (long i = 0; i < SAMPLES; i++) {
        Vec3 out;
        float weight;
        steps.scatter_glossy_source_text(in, vec3(0, 0, 1), (float)exponent, &rng, &out, &weight);
        if (fabs((double)out.y) >= sin(sideways))
            continue;
        int cell = (int)((atan2((double)out.x, (double)out.z) / RADIANS + 90.0) / 3.0);
        cells[cell < CELLS ? cell : CELLS - 1]++;
    }
    double cell_size = 3.0 * RADIANS * 2.0 * sin(sideways), misfit = 0.0;
    int used = 0;
    for (int c = 0; c < CELLS; c++) {
        double expected = cell_mean(c, theta, above) * SAMPLES * cell_size;
        if (expected > 5.0) {
            misfit += pow((double)cells[c] - expected, 2.0) / expected;
            used++;
        }
        fprintf(data, "%.1f %.5f %.5f\n", -90.0 + 3.0 * (c + 0.5), (double)cells[c] / SAMPLES / cell_size,
                cell_mean(c, theta, above));
    }
    fprintf(text, "gap_misfit_per_cell %.2f\ngap_peak %.2f\n", misfit / used, density(1.0, 0.5, theta, above));
}

static void write_leak(FILE *text, int degrees)
{
    Vec3 mirror, in = arrival(degrees * RADIANS, &mirror);
    Rng rng = rng_create(2, (uint64_t)(100 + degrees));
    long leaked = 0;
    for (long i = 0; i < SAMPLES; i++) {
        Vec3 out;
        float weight;
        steps.scatter_glossy_source_text(in, vec3(0, 0, 1), 1000.0f, &rng, &out, &weight);
        leaked += vec3_dot(out, mirror) <= 0.0f;
    }
    double share = 0.5 * (1.0 - cos(degrees * RADIANS));
    fprintf(text, "leak_%d_percent %.2f\nleak_formula_%d_percent %.2f\n", degrees, 100.0 * (double)leaked / SAMPLES,
            degrees, 100.0 * share);
    fprintf(text, "leak_error_%d_percent %.3f\n", degrees, 100.0 * sqrt(share * (1.0 - share) / SAMPLES));
}

// Noise of an estimate from k = 150 photons that arrive as from an even sky, seen from straight above, in percent of
// its mean. Photons in a disc are Poisson: the variance is the sum of squares.
static void write_noise(FILE *text, int n)
{
    enum { PHOTONS = 1000000, K = 150 };
    Rng rng = rng_create(2, (uint64_t)(200 + n));
    double sum = 0.0, squares = 0.0;
    for (long i = 0; i < PHOTONS; i++) {
        double f = pow((double)steps.scatter_diffuse(vec3(0, 0, 1), &rng).z, n);
        sum += f;
        squares += f * f;
    }
    fprintf(text, "noise_%d_percent %.1f\n", n, 100.0 * sqrt(squares * PHOTONS / (sum * sum) / K));
}

int main(int count, char **names)
{
    FILE *data, *text;
    if (!start_figure(count, names, &data, &text))
        return 1;
    write_slice(data, text);
    for (int degrees = 20; degrees <= 80; degrees += 20)
        write_leak(text, degrees);
    write_noise(text, 0);
    write_noise(text, 20);
    write_noise(text, 200);
    return fclose(data) | fclose(text);
}
