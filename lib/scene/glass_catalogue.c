#include "scene/glass_catalogue.h"

#include <math.h>
#include <strings.h>

#define WAVELENGTH_C 0.656273 // µm: the lines of hydrogen and helium that n_C, n_d and n_F are measured at
#define WAVELENGTH_D 0.587562
#define WAVELENGTH_F 0.486133

// Coefficients as collected in the refractiveindex.info database (CC0).
static const SellmeierGlass glasses[] = {
    {"N-BK7", {1.03961212, 0.231792344, 1.01046945}, {0.00600069867, 0.0200179144, 103.560653}, "Schott"},
    {"N-F2", {1.39757037, 0.159201403, 1.2686543}, {0.00995906143, 0.0546931752, 119.248346}, "Schott"},
    {"SF10", {1.61625977, 0.259229334, 1.07762317}, {0.0127534559, 0.0581983954, 116.60768}, "Schott"},
    {"N-SF10", {1.62153902, 0.256287842, 1.64447552}, {0.0122241457, 0.0595736775, 147.468793}, "Schott"},
    {"SF11", {1.73848403, 0.311168974, 1.17490871}, {0.0136068604, 0.0615960463, 121.922711}, "Schott"},
    {"N-SF11", {1.73759695, 0.313747346, 1.89878101}, {0.013188707, 0.0623068142, 155.23629}, "Schott"},
    {"fused_silica",
     {0.6961663, 0.4079426, 0.8974794},
     {0.00467914825849, 0.013512063073959999, 97.93400253792099},
     "Malitson 1965"},
    {"diamond", {0.3306, 4.3356}, {0.030624999999999996, 0.011236}, "Peter 1923"},
    {"water_20C",
     {0.5684027565, 0.1726177391, 0.02086189578, 0.1130748688},
     {0.005101829712, 0.01821153936, 0.02620722293, 10.69792721},
     "Daimon & Masumura 2007, 20 °C"},
};

const SellmeierGlass *glass_at(size_t i)
{
    return i < sizeof glasses / sizeof glasses[0] ? &glasses[i] : NULL;
}

const SellmeierGlass *glass_find(const char *name)
{
    const SellmeierGlass *glass;
    for (size_t i = 0; (glass = glass_at(i)); i++)
        if (strcasecmp(glass->name, name) == 0)
            return glass;
    return NULL;
}

double glass_index(const SellmeierGlass *glass, double wavelength_nm)
{
    double squared = 1e-6 * wavelength_nm * wavelength_nm; // λ² in µm²
    double n2 = 1.0;
    for (int i = 0; i < SELLMEIER_TERMS; i++)
        n2 += glass->b[i] * squared / (squared - glass->c[i]);
    return sqrt(n2);
}

void cauchy_coefficients(double n_d, double abbe, double *a, double *b)
{
    double f_minus_c = 1.0 / (WAVELENGTH_F * WAVELENGTH_F) - 1.0 / (WAVELENGTH_C * WAVELENGTH_C);
    *b = (n_d - 1.0) / (abbe * f_minus_c);
    *a = n_d - *b / (WAVELENGTH_D * WAVELENGTH_D);
}

double cauchy_index(double n_d, double abbe, double wavelength_nm)
{
    double wavelength = 1e-3 * wavelength_nm;
    double a, b;
    cauchy_coefficients(n_d, abbe, &a, &b);
    return a + b / (wavelength * wavelength);
}

void cauchy_through(const float index[3], double *a, double *b)
{
    static const double wavelengths[3] = {WAVELENGTH_RED, WAVELENGTH_GREEN, WAVELENGTH_BLUE};
    double x[3], mean_x = 0.0, mean_n = 0.0, xx = 0.0, xn = 0.0;
    for (int c = 0; c < 3; c++) {
        x[c] = 1e6 / (wavelengths[c] * wavelengths[c]); // 1/λ² in 1/µm²
        mean_x += x[c] / 3.0;
        mean_n += (double)index[c] / 3.0;
    }
    for (int c = 0; c < 3; c++) {
        xx += (x[c] - mean_x) * (x[c] - mean_x);
        xn += (x[c] - mean_x) * ((double)index[c] - mean_n);
    }
    *b = xn / xx;
    *a = mean_n - *b * mean_x;
}
