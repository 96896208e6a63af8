// The tests that checks are made of.
#pragma once

// χ² of counts against expected counts (both over `bins` cells, any cell order), p-value. Cells that expect fewer than 5
// are pooled. A count where nothing at all is expected (below 1e-9 of the sum) gives p = 0.
double chi_square_p(const double *observed, const double *expected, int bins);

// Two-sided p-value of z standard errors. NaN gives 0.
double normal_p(double z);
double student_p(double t, double degrees_of_freedom);

// Two-sided p-value of `hits` in `trials` of probability `share`, exact.
double binomial_p(long hits, long trials, double share);

// Upper bound of a rate after `hits` in `trials`, at this confidence (Clopper & Pearson 1934); and the lower one.
double clopper_pearson_upper(long hits, long trials, double confidence);
double clopper_pearson_lower(long hits, long trials, double confidence);

// Mean and its standard error, added up number by number.
typedef struct {
    double count, sum, squares;
} Sums;
void sums_add(Sums *sums, double value);
double sums_mean(const Sums *sums);
double sums_error(const Sums *sums); // of the mean

void sort_values(double *values, long count);
