// How many times too bright are estimates from the k nearest photons? 1_estimators OUT.dat OUT.txt
// Evenly spread photons, so every difference is the estimator's own. OUT.dat: k, then mean over truth of: box over all
// k, box over k − 1, cone (step 1.6), cone with κ = 1.5, Gaussian as printed, Gaussian made consistent.
#include "1_plane.h"

enum { FILTERS = 6, TRIALS = 40000, PHOTONS = 400, MOST_K = 100 };

static double everywhere(double x, double y)
{
    (void)x, (void)y;
    return 1.0;
}

static double wide_cone(double u)
{
    const double kappa = 1.5;
    return (1.0 - sqrt(u) / kappa) / (1.0 - 2.0 / (3.0 * kappa));
}

// Jensen 1996, without α, over the photons inside the disk.
static double gaussian(double u)
{
    const double beta = 1.953;
    return u < 1.0 ? 1.0 - (1.0 - exp(-beta * u / 2.0)) / (1.0 - exp(-beta)) : 0.0;
}

// One map, one estimate in its middle by every filter, over the truth. The truth is the photons' own number per m².
static void estimate(const PhotonMap *map, size_t k, NearPhoton *near, double values[FILTERS])
{
    float radius2 = INFINITY;
    size_t found = photon_map_nearest(map, vec3(0, 0, 0), k, &radius2, near);
    double scale = 4.0 / ((double)photon_map_count(map) * (double)(PI * radius2));
    for (int f = 0; f < FILTERS; f++)
        values[f] = 0.0;
    for (size_t i = 0; i != found; i++) {
        double u = (double)near[i].distance2 / (double)radius2;
        values[0] += scale;
        values[1] += u < 1.0 ? scale : 0.0;
        values[3] += wide_cone(u) * scale;
        values[4] += 0.918 * gaussian(u) * scale;
        values[5] += 1.72831 * gaussian(u) * scale;
    }
    Gather gather = {.k = k, .radius = INFINITY, .near = near};
    values[2] = plane_estimate(map, 0.0, 0.0, &gather);
}

static void measure(size_t k, NearPhoton *near, FILE *data, FILE *text)
{
    static const char *const names[FILTERS] = {"box_all", "box_inside", "cone", "wide_cone", "printed", "consistent"};
    double sum[FILTERS] = {0.0};
    double cone2 = 0.0;
    Rng rng = rng_create(6, k);
    for (int trial = 0; trial < TRIALS; trial++) {
        double values[FILTERS];
        PhotonMap *map = plane_map(PHOTONS / 4.0, -1.0, 1.0, everywhere, &rng);
        estimate(map, k, near, values);
        photon_map_free(map);
        for (int f = 0; f < FILTERS; f++)
            sum[f] += values[f];
        cone2 += values[2] * values[2];
    }
    fprintf(data, "%zu", k);
    for (int f = 0; f < FILTERS; f++) {
        fprintf(data, " %.5f", sum[f] / TRIALS);
        fprintf(text, "%s_%zu %.4f\n", names[f], k, sum[f] / TRIALS);
    }
    fprintf(data, "\n");
    double mean = sum[2] / TRIALS;
    fprintf(text, "cone_deviation_%zu %.4f\n", k, sqrt(cone2 / TRIALS - mean * mean) / mean);
}

int main(int count, char **names)
{
    static const size_t ks[] = {4, 6, 8, 12, 20, 30, 50, 100};
    static NearPhoton near[PHOTON_MAP_NEAREST_CAPACITY(MOST_K)];
    Error error = {{0}};
    FILE *data = count == 3 ? fopen(names[1], "w") : NULL;
    FILE *text = count == 3 ? fopen(names[2], "w") : NULL;
    if (!data || !text || !steps_load(NULL, &error))
        give_up("usage: 1_estimators OUT.dat OUT.txt");
    for (size_t i = 0; i < sizeof ks / sizeof *ks; i++)
        measure(ks[i], near, data, text);
    return fclose(data) | fclose(text);
}
