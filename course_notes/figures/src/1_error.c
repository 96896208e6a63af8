// Bias and noise of step 1.6 against k and against the number of photons: 1_error OUT.dat OUT.txt
// The floor's irradiance is a wave, E(x) = ½ (1 + 0.4 cos 2πx/W) W/m², W = 0.5 m.
// OUT.dat, block 0, 20 000 photons to the square metre: k, error, bias, noise, each root mean square over the mean
// irradiance, and the same four by the formulas of the text. Blocks 1 to 3: photons to the square metre, error, k, with
// k = 50, with the radius 0.08 m, with the k that balances noise and bias.
#include "1_plane.h"

enum { PLACES = 100, MOST_K = 4000 };
static const double SWING = 0.4;
static const double WAVE = 0.5; // m
static const double MEAN = 0.5; // W/m²

typedef struct {
    double error, bias, noise;
} Errors;

static double wave(double x, double y)
{
    (void)y;
    return MEAN * (1.0 + SWING * cos(2.0 * (double)PI * x / WAVE));
}

// `density`: photons to the square metre, on average. Places keep away from each other and, by 0.3 m and more, from the
// edge of the photons.
static Errors measure(double density, const Gather *settings, int maps)
{
    static double sum[PLACES];
    static double sum2[PLACES];
    for (int i = 0; i < PLACES; i++)
        sum[i] = sum2[i] = 0.0;
    Rng rng = rng_create(11, (uint64_t)(density / MEAN) + settings->k);
    for (int m = 0; m < maps; m++) {
        PhotonMap *map = plane_map(density / MEAN, -0.3, 1.3, wave, &rng);
        Gather gather = *settings;
        for (int i = 0; i < PLACES; i++) {
            double x = 0.1 * (i % 10) + 0.01 * (i / 10);
            double value = plane_estimate(map, x, 0.1 * (i / 10), &gather) - wave(x, 0.0);
            sum[i] += value;
            sum2[i] += value * value;
        }
        photon_map_free(map);
    }
    Errors errors = {0};
    for (int i = 0; i < PLACES; i++) {
        double mean = sum[i] / maps;
        double variance = (sum2[i] - maps * mean * mean) / (maps - 1);
        errors.error += sum2[i] / maps / PLACES;
        errors.noise += variance / PLACES;
        errors.bias += (mean * mean - variance / maps) / PLACES; // what is left of the noise is taken off
    }
    return (Errors){sqrt(errors.error) / MEAN, sqrt(fmax(0.0, errors.bias)) / MEAN, sqrt(errors.noise) / MEAN};
}

// By the formulas, to first order: noise √(1.5/(k−2)) E, bias 0.075 r² E″ with r² = k/(πN) · MEAN/E; both as root mean squares
// over a period.
static Errors predict(double density, double k)
{
    enum { STEPS = 1000 };
    double bias2 = 0.0;
    double noise2 = 0.0;
    double q = 2.0 * (double)PI / WAVE;
    for (int i = 0; i < STEPS; i++) {
        double e = wave(WAVE * (i + 0.5) / STEPS, 0.0);
        double curvature = -q * q * (e - MEAN);
        double bias = 0.075 * k * MEAN / ((double)PI * density * e) * curvature;
        bias2 += bias * bias / STEPS;
        noise2 += 1.5 / (k - 2.0) * e * e / STEPS;
    }
    return (Errors){sqrt(bias2 + noise2) / MEAN, sqrt(bias2) / MEAN, sqrt(noise2) / MEAN};
}

// The c of the text's 1.5/k + (c k/N)², 1/m²: the bias of the disk that k photons fill in light of the mean irradiance.
static double blur_constant(void)
{
    double q = 2.0 * (double)PI / WAVE;
    return 0.075 / (double)PI * SWING * q * q / sqrt(2.0);
}

// Where that sum is least.
static double balanced_k(double density)
{
    double c = blur_constant();
    return cbrt(0.75 / (c * c)) * pow(density, 2.0 / 3.0);
}

static void against_k(FILE *data, FILE *text, NearPhoton *near)
{
    static const size_t ks[] = {5, 8, 12, 20, 35, 50, 80, 120, 200, 350, 500, 800, 1200, 2000};
    const double density = 20000.0;
    double least = INFINITY;
    size_t best = 0;
    for (size_t i = 0; i < sizeof ks / sizeof *ks; i++) {
        Gather gather = {.k = ks[i], .radius = INFINITY, .near = near};
        Errors found = measure(density, &gather, 40);
        Errors formula = predict(density, (double)ks[i]);
        fprintf(data, "%zu %.5f %.5f %.5f %.5f %.5f %.5f\n", ks[i], found.error, found.bias, found.noise, formula.error,
                formula.bias, formula.noise);
        fprintf(text, "k_%zu_percent %.2f\n", ks[i], 100.0 * found.error);
        best = found.error < least ? ks[i] : best;
        least = found.error < least ? found.error : least;
    }
    fprintf(text, "best_k %zu\nleast_percent %.2f\n", best, 100.0 * least);
    fprintf(text, "blur_constant %.4f\nbalanced_factor %.4f\n", blur_constant(), balanced_k(1.0));
    fprintf(text, "balanced_k %.0f\nbalanced_error %.4f\n", balanced_k(density), 1.5 / sqrt(balanced_k(1.0)));
}

static void against_photons(FILE *data, FILE *text, NearPhoton *near)
{
    static const char *const names[3] = {"k_50", "radius", "balanced"};
    for (int rule = 0; rule < 3; rule++) {
        fprintf(data, "\n\n");
        for (int power = 6; power <= 10; power++) {
            double density = 500.0 * pow(4.0, power - 6); // 500 … 128 000
            Gather gather = {.k = 50, .radius = INFINITY, .near = near};
            if (rule == 1)
                gather = (Gather){.k = MOST_K, .radius = 0.08f, .near = near};
            if (rule == 2)
                gather.k = (size_t)balanced_k(density);
            double error = measure(density, &gather, 20).error;
            fprintf(data, "%.0f %.5f %zu\n", density, error, gather.k);
            fprintf(text, "%s_at_%.0f_percent %.2f\n", names[rule], density, 100.0 * error);
        }
    }
}

int main(int count, char **names)
{
    Error error = {{0}};
    NearPhoton *near = malloc(PHOTON_MAP_NEAREST_CAPACITY(MOST_K) * sizeof *near);
    FILE *data = count == 3 ? fopen(names[1], "w") : NULL;
    FILE *text = count == 3 ? fopen(names[2], "w") : NULL;
    if (!near || !data || !text || !steps_load(NULL, &error))
        give_up("usage: 1_error OUT.dat OUT.txt");
    against_k(data, text, near);
    against_photons(data, text, near);
    free(near);
    return fclose(data) | fclose(text);
}
