// Refractive indices of real glasses by wavelength.
#pragma once

#include <stddef.h>

// Dominant wavelengths of the sRGB primaries, nm: the wavelengths at which three-band glass is evaluated.
#define WAVELENGTH_RED   611.28
#define WAVELENGTH_GREEN 549.13
#define WAVELENGTH_BLUE  464.31

// n² = 1 + Σ B_i λ²/(λ² − C_i), λ in µm (Sellmeier 1871). Terms that are not needed are 0.
#define SELLMEIER_TERMS 4
typedef struct {
    const char *name;
    double b[SELLMEIER_TERMS], c[SELLMEIER_TERMS]; // C in µm²
    const char *source;
} SellmeierGlass;

// NULL when there is no glass of that name (case does not matter).
const SellmeierGlass *glass_find(const char *name);
// The glass number i, NULL past the last: for listing.
const SellmeierGlass *glass_at(size_t i);

double glass_index(const SellmeierGlass *glass, double wavelength_nm);

// n(λ) = A + B/λ² (Cauchy), λ in µm, through the index n_d at 587.562 nm, with the slope of Abbe number V_d = (n_d−1)/(n_F−n_C).
void cauchy_coefficients(double n_d, double abbe, double *a, double *b);
double cauchy_index(double n_d, double abbe, double wavelength_nm);
// The same closest to three indices, at the three wavelengths above (least squares).
void cauchy_through(const float index[3], double *a, double *b);
