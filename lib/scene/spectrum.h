// Light by wavelength: lamps' spectra, the colour of a wavelength, a wall's reflectance over wavelength.
//
// Wavelengths are in nm, from WAVELENGTH_FIRST to WAVELENGTH_LAST; a mean over wavelengths is one over this range. Equal energy
// at all of them is white, (1, 1, 1): so lamps without a spectrum of their own have the same colour as without wavelengths.
#pragma once

#include "math/colour.h"

#include <stdbool.h>

#define WAVELENGTH_FIRST 380.0f
#define WAVELENGTH_LAST  730.0f
#define WAVELENGTH_RANGE (WAVELENGTH_LAST - WAVELENGTH_FIRST)

// Step 6.2 draws around this wavelength, and so far to its sides.
#define WAVELENGTH_MIDDLE 535.0f
#define WAVELENGTH_SPREAD 130.0f

// Linear sRGB of equal energy: the mean of the colour-matching functions of step 6.3, times the matrix there.
#define EQUAL_ENERGY_RED   0.366753f
#define EQUAL_ENERGY_GREEN 0.290127f
#define EQUAL_ENERGY_BLUE  0.277286f

// The colour of light of one wavelength, linear sRGB in which equal energy is (1, 1, 1): what step 6.3 does, for lamps and eye
// rays. Channels may be below 0: no screen shows a spectral colour.
Colour spectral_colour(float wavelength);

// Share of light of this wavelength that a wall of this colour reflects: Σ ρ_c b_c(λ), with three smooth functions b_c ≥ 0 whose
// sum is 1 everywhere, and which give the primaries back under equal energy (the idea: Mallett & Yuksel 2019). For reflectances
// in 0…1 it lies in 0…1. Linear, so a lamp's colour becomes a spectrum by it as well.
float reflectance_at(Colour reflectance, float wavelength);

// How a lamp's energy is spread; its mean is 1.
#define SPECTRUM_SIZE 351
typedef struct {
    float line;                 // nm: all energy is here; 0: it is spread
    float value[SPECTRUM_SIZE]; // at each nm; linear between
} Spectrum;

// From a scene file's words:
//   daylight                       CIE D65
//   sodium                         a low-pressure sodium lamp, as a single line at 589.3 nm
//   589.3                          a single line, nm
//   400 0, 500 8, 600 15.6         pairs: nm and energy there; linear between, 0 beyond; at least two, in rising order
// False: it is none of these, or dark; *why says what is wrong.
bool spectrum_parse(const char *text, Spectrum *spectrum, const char **why);

// Energy at a wavelength. 1 without a spectrum (NULL), and at a line's own wavelength, the only one that is asked for there.
float spectrum_at(const Spectrum *spectrum, float wavelength);

// The colour of a lamp of this spectrum and power behind a filter of this colour.
Colour spectrum_colour(const Spectrum *spectrum, Colour power, Colour filter);
