// Directions in cells against a density, and the lobe's integrals.
#include "judge/checks/directions.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_gamma.h>
#include <string.h>

#define FINE 16 // points a side of a cell, by which its share is summed up

static const double pi = 3.14159265358979323846;

double lambert(Vec3d d, const void *normal)
{
    return fmax(0.0, vec3d_dot(d, *(const Vec3d *)normal));
}

static int cosine_bin(double cosine)
{
    return (int)fmin(fmax(0.5 * (cosine + 1.0), 0.0) * COSINES, COSINES - 1);
}

static int row_of(const DirectionDensity *density, double cosine)
{
    if (cosine < 0.0)
        return ROWS + (int)fmin(-cosine * BACK_ROWS, BACK_ROWS - 1);
    return (int)fmin(pow(cosine, density->power) * ROWS, ROWS - 1);
}

void directions_add(DirectionCount *count, const float *direction)
{
    Vec3d d = vec3d_unit(vec3d_of(direction)); // a length that is off by 1e-6 would shift cos¹⁰⁰⁰
    double along = vec3d_dot(d, count->density.axis);
    double across = vec3d_dot(d, count->tangent), up = vec3d_dot(d, count->bitangent);
    double turn = atan2(up, across) / (2.0 * pi) + 0.5;
    int column = (int)fmin(turn * COLUMNS, COLUMNS - 1);
    count->observed[row_of(&count->density, along) * COLUMNS + column]++;
    count->cosines[cosine_bin(along)]++;
    sums_add(&count->along, along);
    sums_add(&count->across, across);
    sums_add(&count->up, up);
    sums_add(&count->repeated, memcmp(count->before, direction, sizeof count->before) == 0);
    memcpy(count->before, direction, sizeof count->before);
}

// One ring of points: cosine and solid angle per azimuth point.
static void expect_ring(DirectionCount *count, int row, double cosine, double measure)
{
    DirectionExpectation *e = &count->expected;
    const DirectionDensity *density = &count->density;
    for (int i = 0; i < COLUMNS * FINE; i++) {
        double azimuth = ((i + 0.5) / (COLUMNS * FINE) - 0.5) * 2.0 * pi;
        Vec3d d = vec3d_about(density->axis, count->tangent, count->bitangent, cosine, azimuth);
        double share = measure * density->density(d, density->input);
        e->share[row * COLUMNS + i / FINE] += share;
        e->cosines[cosine_bin(cosine)] += share;
        e->along += share * cosine;
        e->across += share * vec3d_dot(d, count->tangent);
        e->up += share * vec3d_dot(d, count->bitangent);
    }
}

void directions_begin(DirectionCount *count, const DirectionDensity *density)
{
    *count = (DirectionCount){.density = *density};
    vec3d_frame(density->axis, &count->tangent, &count->bitangent);
    DirectionExpectation *expected = &count->expected;
    double power = density->power, sum = 0.0;
    for (int i = 0; i < ROWS * FINE; i++) { // cos = x^(1/power), d cos = cos/(power·x) dx
        double x = (i + 0.5) / (ROWS * FINE);
        double cosine = pow(x, 1.0 / power);
        expect_ring(count, i / FINE, cosine, cosine / (power * x * ROWS * FINE));
    }
    for (int i = 0; i < BACK_ROWS * FINE; i++) {
        double x = (i + 0.5) / (BACK_ROWS * FINE);
        expect_ring(count, ROWS + i / FINE, -x, 1.0 / (BACK_ROWS * FINE));
    }
    for (int i = 0; i < CELLS; i++)
        sum += expected->share[i];
    for (int i = 0; i < CELLS; i++)
        expected->share[i] /= sum;
    for (int i = 0; i < COSINES; i++)
        expected->cosines[i] /= sum;
    expected->along /= sum;
    expected->across /= sum;
    expected->up /= sum;
}

// A cell of which the surface leaves a sliver may have a share of 0 by its points and still a sample: the rare ones are
// taken together, with the commonest if they are too few by themselves.
double directions_p(const DirectionCount *count)
{
    const DirectionExpectation *expected = &count->expected;
    double observed[CELLS + 1], wanted[CELLS + 1], total = count->along.count;
    int cells = 0, largest = 0;
    double rare = 0.0, rare_wanted = 0.0;
    for (int i = 0; i < CELLS; i++) {
        if (expected->share[i] * total < 5.0) {
            rare += count->observed[i];
            rare_wanted += expected->share[i] * total;
            continue;
        }
        observed[cells] = count->observed[i];
        wanted[cells] = expected->share[i] * total;
        largest = wanted[cells] > wanted[largest] ? cells : largest;
        cells++;
    }
    if (cells == 0)
        return 1.0;
    if (rare_wanted >= 5.0 || rare > 60.0) {
        observed[cells] = rare;
        wanted[cells++] = fmax(rare_wanted, 5.0);
    } else {
        observed[largest] += rare;
        wanted[largest] += rare_wanted;
    }
    return chi_square_p(observed, wanted, cells);
}

void mean_feature(const Sums *sums, double expected, Finding *finding)
{
    finding_feature(finding, sums_mean(sums) - expected, sums_error(sums));
}

void vector_features(const float *found, Vec3d expected, Finding *finding)
{
    finding_feature(finding, found ? (double)found[0] - expected.x : (double)NAN, 0.0);
    finding_feature(finding, found ? (double)found[1] - expected.y : (double)NAN, 0.0);
    finding_feature(finding, found ? (double)found[2] - expected.z : (double)NAN, 0.0);
}

void directions_features(const DirectionCount *count, Finding *finding)
{
    mean_feature(&count->along, count->expected.along, finding);
    mean_feature(&count->across, count->expected.across, finding);
    mean_feature(&count->up, count->expected.up, finding);
    finding_feature(finding, sums_mean(&count->repeated), 0.1);
}

void directions_histogram(const DirectionCount *count, const char *title, Finding *finding)
{
    double wanted[COSINES];
    for (int i = 0; i < COSINES; i++)
        wanted[i] = count->expected.cosines[i] * count->along.count;
    finding_histogram(finding, title, -1.0, 1.0, count->cosines, wanted, COSINES);
}

// I(x; a, b), regularised. Underflow is a 0 like any other.
static double beta_share(double a, double b, double x)
{
    gsl_sf_result result;
    gsl_error_handler_t *before = gsl_set_error_handler_off();
    int status = gsl_sf_beta_inc_e(a, b, x, &result);
    gsl_set_error_handler(before);
    return status == GSL_SUCCESS ? result.val : 0.0;
}

double lobe_above_exactly(double n, double c)
{
    double s2 = 1.0 - c * c;
    return pi * (2.0 - beta_share(0.5 * n + 0.5, 0.5, s2)) / (n + 1.0);
}

double lobe_weighted_exactly(double n, double c)
{
    double s2 = 1.0 - c * c;
    double ratio = exp(lgamma(0.5 * n + 0.5) - lgamma(0.5 * n + 1.0));
    double share = n > 0.0 ? beta_share(0.5 * n, 0.5, s2) : 1.0;
    return (2.0 * pi * c + sqrt(pi) * ratio * pow(s2, 0.5 * n) - pi * c * share) / (n + 2.0);
}
