// What a photon's path is made of: the calls that steps 1.5 and 3.4 put together.
//
// The library keeps the books meanwhile. Every photon_fly ends in exactly one of: a surface, the open (escaped), the
// depth limit. So the flux a path carries is known at every arrival and departure without the student's help.
#pragma once

#include "math/rng.h"
#include "photons/photon.h"
#include "scene/scene.h"

// A fresh white photon on a light's surface.
static inline Photon photon_create(Vec3 position, Vec3 direction, Colour power)
{
    return (Photon){.position = position, .direction = direction, .power = power, .from = NO_PRIMITIVE};
}

// Sends the photon on from photon->position along photon->direction to the next surface. True: *hit tells where;
// photon->bounce has been raised by one, its position and direction are as they were. False: its path ends here,
// because it left the scene, met a light (which absorbs it) or has reached the depth limit. A direction that is not of
// unit length (NaN, say) ends it, too, as escaped; the program reports how many did.
bool photon_fly(PhotonTrace *trace, Photon *photon, Hit *hit);

// What the surface is for this photon: one of a single wavelength meets there the reflectances at that wavelength.
Material photon_surface(const Photon *photon, const Hit *hit);

// Leaves a copy of the photon at the hit: its power, its colour and where it came from. For diffuse and glossy
// surfaces only. Flux of a single wavelength becomes red, green and blue here (step 6.3).
void photon_store(PhotonTrace *trace, const Photon *photon, const Hit *hit);

// A glossy hit: roulette (step 1.4) with ρ_d + ρ_s, then the diffuse part (step 1.3) or the lobe (step 2.3 or 2.4),
// chosen in proportion to the flux each would carry on. False: the photon is absorbed. Materials that no step is about
// come here, too, and scatter by their own rule.
bool photon_scatter_glossy(Photon *photon, const Hit *hit, Rng *rng);

// A glass hit by the white photon's mean index: Fresnel (step 3.2) decides between reflect (1.1) and refract (3.1).
// What the loop of step 1.5 uses; step 3.4 does better.
void photon_scatter_glass(Photon *photon, const Hit *hit, Rng *rng);

// η = n_i/n_t for light that meets glass of this index: 1/index on the way in, index on the way out.
static inline float glass_eta(const Hit *hit, float index)
{
    return hit->entering ? 1.0f / index : index;
}
