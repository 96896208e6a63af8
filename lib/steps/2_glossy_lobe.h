// Stage 2, glossy lobe: the contracts of its steps.
//
// "The source text" is the student project that this course goes back to (course 02562, Technical University of
// Denmark), which added glossy photons and colour dispersion to a photon mapper. Step 2.3 follows it to the letter,
// step 2.4 puts it right.
#pragma once

#include "math/rng.h"
#include "math/vec3.h"

#include <stdbool.h>

// 2.1  A unit direction in the cosine lobe about +z: density (n+1)/(2π)·cosⁿα, α the angle to +z, n = exponent ≥ 0.
//          cosα = u₁^(1/(n+1)),  sinα = √(1 − u₁^(2/(n+1))),  φ = 2πu₂
// In float the root loses its digits for large n; −expm1(2/(n+1)·ln u₁) keeps them.
Vec3 sample_lobe(float exponent, Rng *rng);

// 2.2  Turns a direction given about +z so that it stands about `axis` (unit): +z goes to axis, lengths and angles
// stay. Must work for every axis, ±z included.
Vec3 turn_to(Vec3 local, Vec3 axis);

#define MAX_LOBE_TRIES 1000

// 2.3  The source text's glossy bounce. `direction` (unit) flies towards the surface, `normal` (unit) faces it. Draw
// a diffuse direction. If it lies on the mirror direction's side, dot(out, mirror) > 0, take a lobe sample about the
// mirror direction instead, redrawn while it is below the surface; otherwise keep the diffuse one. *weight is 1: as
// much flux leaves as came. The density of *out:
//          p = P·cosⁿα/I_P for α < 90°,  cosθ_o/π beyond,  P = (1 + cosθ)/2
// After MAX_LOBE_TRIES redraws: call redraw_cap_reached() and return false.
bool scatter_glossy_source_text(Vec3 direction, Vec3 normal, float exponent, Rng *rng, Vec3 *out, float *weight);

// 2.4  The bounce that never makes energy: one lobe sample about the mirror direction. Below the surface: absorbed,
// return false. The weight makes it the modified Phong BRDF f = ρ(n+2)/(2π)·cosⁿα (Lafortune & Willems 1994); ρ is
// the caller's:
//          weight = f·cosθ_o/(ρ·pdf) = (n+2)/(n+1)·cosθ_o
// What the lobe loses below the surface is really lost: at n = 100 and 80° a share of 0.175ρ is reflected, where step
// 2.3 sends on all of ρ, but a part of it the wrong way.
bool scatter_glossy_phong(Vec3 direction, Vec3 normal, float exponent, Rng *rng, Vec3 *out, float *weight);
