// Stage 4, final gathering: the contracts of its steps.
//
// Until here light is looked up in the map where one looks, and its blotches are seen. Now rays go out from there over the
// hemisphere, and the map is looked up where they end (Jensen 1996): hundreds of look-ups are averaged. Neighbouring
// points share what they found (irradiance caching: Ward, Rubinstein & Clear 1988).
#pragma once

#include "math/ray.h"
#include "math/rng.h"
#include "photons/irradiance.h"
#include "scene/scene.h"

#include <stdbool.h>
#include <stddef.h>

// 4.1  The direction of a gather ray in cell (ring j, sector k) of GATHER_RINGS M × GATHER_SECTORS N: a unit vector about
// +z. With one draw each, u for the ring and then v for the sector:
//          sin²θ = (j + u)/M,  φ = 2π(k + v)/N
// Every cell takes the same share of the cosine: all cells together have the density cosθ/π.
Vec3 gather_direction(int ring, int sector, Rng *rng);

// 4.2  The radiance that comes back along a gather ray, W/(m²·sr). gather_meet gives one surface after the other:
//        a light, or nothing   0: shadow rays have counted the lamps, the caustic map what comes of them by mirrors and glass
//        diffuse, glossy       the light that leaves there, as if it were matt: L = ρE/π,
//                              with E from gather_irradiance and ρ from gather_albedo
//        mirror                go on along steps.reflect, weighed by material->specular
//        glass                 go on, reflected with probability F = steps.fresnel, otherwise refracted and weighed by η²,
//                              since radiance is squeezed in the denser side; index: steps.refractive_index, WHITE (where
//                              glass disperses, gather_send makes each ray one colour's; alone, the step has the mean)
// A ray that goes on starts at hit.position, from hit.primitive.
Colour gather_radiance(GatherTrace *trace, Ray ray, Rng *rng);

// 4.3  Irradiance at a hit, W/m²: one gather ray for each cell, in the order of rings and, within them, sectors: a
// direction by 4.1, turned to stand about hit->normal by frame_about, from hit->position and hit->primitive, sent by
// gather_send, which calls 4.2. With the density cosθ/π
//          E = (π/MN) Σ L_jk
// Fills in seen->radiance and, from gather_distance, seen->distance, for each cell: how E changes from place to place is
// found from them.
Colour gather_hemisphere(GatherTrace *trace, const Hit *hit, Hemisphere *seen, Rng *rng);

// 4.4  How far an estimate reaches: R, the harmonic mean of the distances, M·N / Σ 1/r_jk, m; not below `shortest`, not
// above `longest`. Where things are near, light changes quickly. The open, at INFINITY, adds nothing to the sum.
float irradiance_reach(const Hemisphere *seen, float shortest, float longest);

// 4.5  Irradiance at a place by the estimates near it. The error of estimate i there is
//          ε_i = |x − x_i|/R_i + √(1 − n·n_i)
// Those with ε_i < accuracy serve, unless the place lies below their surface:
//          (x − x_i)·(n + n_i)/2 < −0.05·accuracy·R_i
// The answer is their mean, each as irradiance_extrapolate carries it to the place, weighed by 1 − ε_i/accuracy. False,
// and *irradiance left alone, where none serves. n·n_i may come out a little above 1.
bool interpolate_irradiance(const IrradianceEstimate *const near[], size_t count, Vec3 position, Vec3 normal,
                            float accuracy, Colour *irradiance);
