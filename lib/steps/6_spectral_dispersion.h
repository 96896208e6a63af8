// Stage 6, spectral dispersion: the contracts of its steps.
//
// Stage 3 parts white light into three colours, so a prism makes three spots. Here a photon has one wavelength for its whole
// life, drawn where it is emitted. Glass then has one index for it, a wall one reflectance, and its flux is one number, three
// times the same in photon.power. It becomes a colour where it is stored; the mean over many wavelengths is a full spectrum.
#pragma once

#include "math/rng.h"
#include "photons/photon.h"
#include "scene/material.h"
#include "scene/spectrum.h"

// 6.1  The refractive index of glass at a wavelength in nm. Its formula takes λ in µm:
//        glass->sellmeier, unless NULL   n² = 1 + Σ b_i λ²/(λ² − c_i), over its SELLMEIER_TERMS terms (Sellmeier 1871);
//                                        c_i is in µm², and squared already
//        otherwise                       n = A + B/λ², with A and B (µm²) of glass->cauchy (Cauchy 1836)
float index_at_wavelength(const Material *glass, float wavelength);

// 6.2  A wavelength by importance, for u in [0, 1): the eye hardly sees the ends of the range, and few photons are spent there.
// Between WAVELENGTH_FIRST and WAVELENGTH_LAST, with m = WAVELENGTH_MIDDLE and s = WAVELENGTH_SPREAD, the density is
//          p(λ) = 1/(s (T(last) − T(first)) cosh²((λ − m)/s)),  T(λ) = tanh((λ − m)/s)
// (the shape: Radziszewski, Boryczko & Alda 2009). By inversion T(λ) = T(first) + u (T(last) − T(first)).
// *weight = 1/(WAVELENGTH_RANGE p(λ)): what the photon counts, 1 in the mean over u. u = 0 gives WAVELENGTH_FIRST.
float draw_wavelength(float u, float *weight);

// 6.3  The colour of light of one wavelength in nm, linear sRGB, in which equal energy at all wavelengths is white: the mean
// over the range is (1, 1, 1). First CIE 1931 by lobes (Wyman, Sloan & Shirley 2013):
//          x = 1.056 g(599.8, 37.9, 31.0) + 0.362 g(442.0, 16.0, 26.7) − 0.065 g(501.1, 20.4, 26.2)
//          y = 0.821 g(568.8, 46.9, 40.5) + 0.286 g(530.9, 16.3, 31.1)
//          z = 1.217 g(437.0, 11.8, 36.0) + 0.681 g(459.0, 26.0, 13.8)
//          g(μ, σ₁, σ₂) = exp(−(λ − μ)²/(2σ²)),  σ = σ₁ below μ, σ₂ above it
// then linear sRGB (IEC 61966-2-1), and each channel divided by what equal energy has there:
//          r = ( 3.2406 x − 1.5372 y − 0.4986 z)/EQUAL_ENERGY_RED
//          g = (−0.9689 x + 1.8758 y + 0.0415 z)/EQUAL_ENERGY_GREEN
//          b = ( 0.0557 x − 0.2040 y + 1.0570 z)/EQUAL_ENERGY_BLUE
// Channels may be below 0, and stay so: only sums of many wavelengths are colours that can be shown.
Colour wavelength_colour(float wavelength);

// 6.4  The life of a photon of one wavelength, photon.wavelength: as in 3.4 (or by a loop, as in 1.5), but
//        what it meets is photon_surface(&photon, &hit): diffuse and specular are the reflectances at its wavelength
//        glass   n by 6.1 at its wavelength, whether it enters or leaves; reflect with probability F (3.2), otherwise
//                refract (3.1); its power stays as it is, and nothing splits
// photon_scatter_glossy and photon_store know of wavelengths; the latter makes a colour of it by 6.3.
void trace_photon_at_wavelength(PhotonTrace *trace, Photon photon, Rng *rng);
