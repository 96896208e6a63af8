// Stage 3, colour dispersion: the contracts of its steps.
#pragma once

#include "math/rng.h"
#include "photons/photon.h"
#include "scene/material.h"

// 3.1  Snell's law. `direction` (unit) flies towards the surface, `normal` (unit) faces it, eta = n_i/n_t. With
// cosθ_i = −d·n:
//          cosθ_t = √(1 − η²(1 − cos²θ_i)),   t = ηd + (η cosθ_i − cosθ_t)n
// A negative argument of the root is total internal reflection: return false and leave *refracted alone.
bool refract(Vec3 direction, Vec3 normal, float eta, Vec3 *refracted);

// 3.2  Fresnel reflectance of clear glass for unpolarised light, 0…1; cos_i = cosθ_i > 0, eta = n_i/n_t. 1 under
// total reflection.
//          r_s = (η cosθ_i − cosθ_t)/(η cosθ_i + cosθ_t),  r_p = (cosθ_i − η cosθ_t)/(cosθ_i + η cosθ_t)
//          R = (r_s² + r_p²)/2
float fresnel(float cos_i, float eta);

// 3.3  The refractive index that a photon of this colour meets: glass->index[0…2] for RED, GREEN, BLUE; for WHITE the
// mean of the three.
float refractive_index(const Material *glass, PhotonColour colour);

// 3.4  The life of one photon as a recursion that carries the colour (photon.colour): fly once, do what step 1.5 does
// at rough surfaces and mirrors, and call yourself for what flies on. At glass, with F_c the Fresnel reflectance of
// channel c at its own index and F̄ = (F_r+F_g+F_b)/3 (a coloured photon: only its own F):
//   with probability F̄   reflect; power_c ·= F_c/F̄; white stays white
//   otherwise            power_c ·= (1−F_c)/(1−F̄); split (step 3.5); refract each child by its own index and follow it
// A photon's flux has no n² factor (Veach 1996).
void trace_photon_in_colour(PhotonTrace *trace, Photon photon, Rng *rng);

// 3.5  What a photon becomes as it refracts: a white one in dispersing glass (glass->disperses) becomes three, each
// with one channel of its power and that channel's colour, in this order: (Φr,0,0) RED, (0,Φg,0) GREEN, (0,0,Φb) BLUE.
// All else they have from *photon. Any other photon goes on as it is. Returns how many: 3 or 1.
int split_colour(const Photon *photon, const Material *glass, Photon children[3]);
