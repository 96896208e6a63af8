// Stage 1, diffuse photon map: the contracts of its steps. Each is one function in one file. A step may call those that
// its contract names, as steps.scatter_diffuse(…), and any function of the library.
#pragma once

#include "math/rng.h"
#include "photons/gather.h"
#include "photons/photon.h"

// 1.1  The mirror direction: `direction` (unit, flying towards the surface) reflected about `normal` (unit, either
// side).
//          r = d − 2(d·n)n
Vec3 reflect(Vec3 direction, Vec3 normal);

// 1.2  A photon from a rectangular light: a uniform point on it, a direction from the cosine hemisphere about
// light->direction (density cosθ/π), and the light's whole power, light->power = πAL (W). The photon pass divides
// that by the number of photons emitted. Start from photon_create(position, direction, power). Where the
// rectangle lies: see Light in lib/scene/light.h.
Photon emit_photon(const Light *light, Rng *rng);

// 1.3  A unit direction of a diffuse bounce: above `normal` (unit), density cosθ/π (Lambert). By inversion:
//          cosθ = √u₁,  φ = 2πu₂
Vec3 scatter_diffuse(Vec3 normal, Rng *rng);

// 1.4  Russian roulette (Arvo & Kirk 1990): does the photon survive a surface of this reflectance (0…1 per channel)?
//          p = min(1, Σ Φ_c ρ_c / Σ Φ_c)
// A survivor's power becomes Φ_c ρ_c / p, so that the mean over many photons is Φρ. False: absorbed, power is left
// alone. A photon without power stays without, and never becomes NaN.
bool russian_roulette(Colour *power, Colour reflectance, Rng *rng);

// 1.5  The life of one photon, as a loop: fly, store where it lands on a rough surface, then by the material
//        diffuse   roulette with material->diffuse, then scatter_diffuse
//        glossy    photon_scatter_glossy
//        mirror    roulette with material->specular, then reflect
//        glass     photon_scatter_glass
// until photon_fly or a roulette ends it. A photon is stored with the power it arrives with, before the roulette. It
// flies on from hit.position. Nothing is stored on mirrors and glass. These calls stand in
// lib/photons/pass/trace.h, Hit in lib/scene/scene.h, Material in lib/scene/material.h.
void trace_photon(PhotonTrace *trace, Photon photon, Rng *rng);

// 1.6  Reflected radiance, W/(m²·sr), from the photons near a point (Jensen 1996), with a cone filter (Jensen 2001):
//          L = 3/(πr²) Σ f_r(wi, wo) Φ (1 − d/r)
// d: a photon's distance; r: the radius that gather_near reports, the distance to the k-th photon or the largest
// allowed. Only photons that arrived on the side of hit->normal count. No cosine: the flux Φ has it already. `wo` is
// the unit direction to the eye. No photon near: 0. See lib/photons/gather.h and lib/photons/photon_map.h.
Colour estimate_radiance(const PhotonMap *map, const Hit *hit, Vec3 wo, Gather *gather);
