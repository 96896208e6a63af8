// The bias of k-nearest density estimates, through the photon map: how many times too bright each filter is
// on average.
//
// N photons of power 1 are spread evenly over a square of area A, so the truth is N/A. The area of the disc
// up to the k-th nearest, as a share x of A, has the Beta(k, N + 1 − k) distribution, with E[1/x] = N/(k −
// 1); the k − 1 photons inside are spread evenly over the disc, and d²/r² is uniform for them. Every
// expectation below follows, whatever N is.
#include "unit/test_common.h"

enum { PHOTONS = 500, TRIALS = FEWER(10000), MOST_K = 50 };

// What a photon at distance² u (in units of r²) adds to the estimate, apart from the factor 1/(πr²).
typedef double (*Filter)(double u, double parameter);

static double box(double u, double reach)
{
    return u < reach ? 1.0 : 0.0;
}

static double cone(double u, double kappa)
{
    return (1.0 - sqrt(u) / kappa) / (1.0 - 2.0 / (3.0 * kappa));
}

// Jensen 1996 with β = 1.953, over the k − 1 photons inside the disc.
static double gaussian(double u, double alpha)
{
    const double beta = 1.953;
    return u < 1.0 ? alpha * (1.0 - (1.0 - exp(-beta * u / 2.0)) / (1.0 - exp(-beta))) : 0.0;
}

static double biweight(double u, double scale)
{
    return scale * (1.0 - u) * (1.0 - u);
}

typedef struct {
    const char *name;
    Filter filter;
    double parameter;
    double excess; // expectation − 1, times k − 1; NaN: see `expected`
    double expected;
} Case;

static const Case cases[] = {
    {"box over all k", box, INFINITY, 1.0, 0.0},
    {"box over k - 1", box, 1.0, 0.0, 0.0},
    {"cone, kappa 1", cone, 1.0, 0.0, 0.0},
    {"cone, kappa 1.5", cone, 1.5, (1.0 - 1.0 / 1.5) / (1.0 - 2.0 / 4.5), 0.0},
    {"Gaussian as commonly printed", gaussian, 0.918, NAN, 0.5312},
    {"Gaussian, consistent", gaussian, 1.72831, 0.0, 0.0},
    {"biweight", biweight, 3.0, 0.0, 0.0},
};
enum { CASES = sizeof cases / sizeof *cases };

// Photons spread evenly over a square with sides of 2 m.
static PhotonMap *make_map(uint64_t seed, uint64_t trial)
{
    StoredPhoton *photons = calloc(PHOTONS, sizeof *photons);
    assert_non_null(photons);
    Rng rng = rng_create(seed, trial);
    for (size_t i = 0; i < PHOTONS; i++) {
        float x = 2.0f * rng_float(&rng) - 1.0f;
        float z = 2.0f * rng_float(&rng) - 1.0f;
        photons[i].position = vec3(x, 0.5f, z);
    }
    Error error = {{0}};
    PhotonMap *map = photon_map_build(photons, PHOTONS, &error);
    assert_non_null(map);
    return map;
}

// Estimate over truth in the middle of the square, by each filter.
static void estimate(const PhotonMap *map, size_t k, double values[CASES])
{
    NearPhoton near[PHOTON_MAP_NEAREST_CAPACITY(MOST_K)];
    float radius2 = INFINITY;
    assert_int_equal(photon_map_nearest(map, vec3(0.0f, 0.5f, 0.0f), k, &radius2, near), k);
    assert_true(radius2 < 1.0f); // the disc stays in the square
    for (int c = 0; c < CASES; c++) {
        double sum = 0.0;
        for (size_t i = 0; i < k; i++)
            sum += cases[c].filter((double)near[i].distance2 / (double)radius2, cases[c].parameter);
        values[c] = sum / ((double)PI * (double)radius2) / (PHOTONS / 4.0);
    }
}

static void check_filters(size_t k)
{
    Mean means[CASES] = {{0}};
    for (uint64_t trial = 0; trial < TRIALS; trial++) {
        double values[CASES];
        PhotonMap *map = make_map(k, trial);
        estimate(map, k, values);
        photon_map_free(map);
        for (int c = 0; c < CASES; c++)
            mean_add(&means[c], values[c]);
    }
    for (int c = 0; c < CASES; c++) {
        const Case *filter = &cases[c];
        double expected = isnan(filter->excess) ? filter->expected : 1.0 + filter->excess / (double)(k - 1);
        double mean = mean_value(&means[c]), error = mean_error(&means[c]);
        assert_true(error < 1.0 / sqrt(TRIALS)); // or the check would say little
        if (!(fabs(mean - expected) < 4.0 * error))
            fail_msg("%s, k = %zu: %.4f ± %.4f, expected %.4f", filter->name, k, mean, error, expected);
    }
}

TEST(test_filters)
{
    check_filters(8);
    check_filters(20);
    check_filters(50);
}
