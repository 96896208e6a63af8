#include "judge/checks/statistics.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdlib.h>

double chi_square_p(const double *observed, const double *expected, int bins)
{
    double statistic = 0.0, pooled_observed = 0.0, pooled_expected = 0.0, total = 0.0;
    int cells = 0;
    for (int i = 0; i < bins; i++)
        total += expected[i];
    for (int i = 0; i < bins; i++) {
        if (expected[i] < 1e-9 * total && observed[i] > 0.0)
            return 0.0;
        if (expected[i] < 5.0) {
            pooled_observed += observed[i];
            pooled_expected += expected[i];
            continue;
        }
        double off = observed[i] - expected[i];
        statistic += off * off / expected[i];
        cells++;
    }
    if (pooled_expected >= 5.0) {
        double off = pooled_observed - pooled_expected;
        statistic += off * off / pooled_expected;
        cells++;
    } else if (pooled_observed > 0.0 &&
               binomial_p((long)pooled_observed, (long)total, pooled_expected / total) < 1e-12) {
        return 0.0; // hundreds where next to none belong
    }
    if (!isfinite(statistic))
        return 0.0;
    return cells < 2 ? 1.0 : gsl_cdf_chisq_Q(statistic, cells - 1);
}

double normal_p(double z)
{
    return isnan(z) ? 0.0 : 2.0 * gsl_cdf_ugaussian_Q(fabs(z));
}

double student_p(double t, double degrees_of_freedom)
{
    return isnan(t) ? 0.0 : 2.0 * gsl_cdf_tdist_Q(fabs(t), degrees_of_freedom);
}

double binomial_p(long hits, long trials, double share)
{
    double below = gsl_cdf_binomial_P((unsigned)hits, share, (unsigned)trials);
    double above = hits > 0 ? gsl_cdf_binomial_Q((unsigned)(hits - 1), share, (unsigned)trials) : 1.0;
    return fmin(1.0, 2.0 * fmin(below, above));
}

double clopper_pearson_upper(long hits, long trials, double confidence)
{
    return hits >= trials ? 1.0 : gsl_cdf_beta_Pinv(confidence, (double)hits + 1.0, (double)(trials - hits));
}

double clopper_pearson_lower(long hits, long trials, double confidence)
{
    return hits <= 0 ? 0.0 : gsl_cdf_beta_Pinv(1.0 - confidence, (double)hits, (double)(trials - hits) + 1.0);
}

void sums_add(Sums *sums, double value)
{
    sums->count += 1.0;
    sums->sum += value;
    sums->squares += value * value;
}

double sums_mean(const Sums *sums)
{
    return sums->sum / sums->count;
}

double sums_error(const Sums *sums)
{
    double mean = sums_mean(sums);
    return sqrt(fmax(0.0, sums->squares / sums->count - mean * mean) / (sums->count - 1.0));
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

void sort_values(double *values, long count)
{
    qsort(values, (size_t)count, sizeof *values, by_value);
}
