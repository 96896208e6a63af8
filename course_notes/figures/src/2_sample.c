// What step 2.1 draws, and what the misprinted z would make of it: 2_sample OUT.dat OUT.txt
// OUT.dat: block 0: cosα, density for n = 1, 5, 20; block 1: angle to the axis (degrees), share per degree of right
// and of misprinted lobe, n = 20; block 2: sideways, z and misprinted z of 400 samples, n = 5.
#include "2_lobe.h"

enum { SAMPLES = 200000, CELLS = 40, DOTS = 400 };

static void write_histograms(FILE *data)
{
    static const float exponents[3] = {1.0f, 5.0f, 20.0f};
    static long cells[3][CELLS];
    for (int e = 0; e < 3; e++) {
        Rng rng = rng_create(2, (uint64_t)e);
        for (long i = 0; i < SAMPLES; i++) {
            int cell = (int)(steps.sample_lobe(exponents[e], &rng).z * CELLS);
            cells[e][cell < CELLS ? cell : CELLS - 1]++;
        }
    }
    for (int c = 0; c < CELLS; c++) {
        fprintf(data, "%.4f", (c + 0.5) / CELLS);
        for (int e = 0; e < 3; e++)
            fprintf(data, " %.4f", (double)cells[e][c] * CELLS / SAMPLES);
        fprintf(data, "\n");
    }
    fprintf(data, "\n\n");
}

// The source text's prose: the same x and y, but 1 − cosα for z.
static Vec3 misprinted(Vec3 right)
{
    return vec3(right.x, right.y, 1.0f - right.z);
}

static double angle_to_z(Vec3 d)
{
    return atan2(hypot((double)d.x, (double)d.y), (double)d.z) / RADIANS;
}

static void write_misprint(FILE *data, FILE *text)
{
    static long right[90], wrong[90];
    Rng rng = rng_create(2, 21);
    double square = 0.0, nearest = 90.0;
    for (long i = 0; i < SAMPLES; i++) {
        Vec3 d = steps.sample_lobe(20.0f, &rng);
        Vec3 m = misprinted(d);
        int cell = (int)angle_to_z(d);
        right[cell < 90 ? cell : 89]++;
        cell = (int)angle_to_z(m);
        wrong[cell < 90 ? cell : 89]++;
        square += (double)vec3_dot(m, m) / SAMPLES;
        nearest = fmin(nearest, angle_to_z(m));
    }
    for (int c = 0; c < 90; c++)
        fprintf(data, "%.1f %.5f %.5f\n", c + 0.5, (double)right[c] / SAMPLES, (double)wrong[c] / SAMPLES);
    fprintf(text, "misprint_square_20 %.4f\nmisprint_nearest_20 %.1f\n", square, nearest);
    fprintf(data, "\n\n");
    for (int i = 0; i < DOTS; i++) {
        Vec3 d = steps.sample_lobe(5.0f, &rng);
        double side = copysign(hypot((double)d.x, (double)d.y), (double)d.x);
        fprintf(data, "%.4f %.4f %.4f\n", side, (double)d.z, 1.0 - (double)d.z);
    }
}

// How far sinα in float is from the truth, root mean square of the relative error: by the root as it is written, and
// by expm1.
static void write_digits(FILE *text)
{
    static const double exponents[3] = {100.0, 10000.0, 1000000.0};
    static const char *const names[3] = {"1e2", "1e4", "1e6"};
    for (int e = 0; e < 3; e++) {
        Rng rng = rng_create(2, 30 + (uint64_t)e);
        float power = 2.0f / ((float)exponents[e] + 1.0f);
        double plain = 0.0, careful = 0.0;
        for (int i = 0; i < SAMPLES; i++) {
            float u = 1.0f - rng_float(&rng);
            double truth = sqrt(-expm1(2.0 * log((double)u) / (exponents[e] + 1.0)));
            if (truth == 0.0)
                continue;
            double error = (double)sqrtf(1.0f - powf(u, power)) / truth - 1.0;
            plain += error * error / SAMPLES;
            error = (double)sqrtf(-expm1f(power * logf(u))) / truth - 1.0;
            careful += error * error / SAMPLES;
        }
        fprintf(text, "sine_error_plain_%s_percent %.6f\nsine_error_expm1_%s_percent %.6f\n", names[e],
                100.0 * sqrt(plain), names[e], 100.0 * sqrt(careful));
    }
}

int main(int count, char **names)
{
    FILE *data, *text;
    if (!start_figure(count, names, &data, &text))
        return 1;
    write_histograms(data);
    write_misprint(data, text);
    write_digits(text);
    return fclose(data) | fclose(text);
}
