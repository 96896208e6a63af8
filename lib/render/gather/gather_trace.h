// What a gather ray is made of: the calls that steps 4.2, 4.3 and 4.5 put together.
#pragma once

#include "math/rng.h"
#include "photons/irradiance.h"
#include "scene/scene.h"

// Sends a gather ray: what it brings (step 4.2), W/(m²·sr). Where glass disperses, the ray stands for one colour from there on,
// drawn at random: gather_meet shows glass that has this colour's index for all, and only its channel counts, three times.
Colour gather_send(GatherTrace *trace, Ray ray, Rng *rng);

// The next surface along the ray. False: it leaves the scene, or has met too many surfaces.
bool gather_meet(GatherTrace *trace, const Ray *ray, Hit *hit);

// How far the last gather ray flew to its first surface, m; INFINITY: it met none.
float gather_distance(const GatherTrace *trace);

// Irradiance where a gather ray ends, W/m²: kept at photons beforehand (Christensen 1999). Near a corner, where those are
// too few on one side, it is gathered once more.
Colour gather_irradiance(GatherTrace *trace, const Hit *hit);

// Share ρ of the light that a surface sends back against the ray, so that ρE/π is right: of a broad lobe on something flat by how
// light falls in there, elsewhere as if it were matt.
Colour gather_albedo(const GatherTrace *trace, const Ray *ray, const Hit *hit);

// An estimate carried along its gradients to another place and normal, W/m²; bounded, so that no straight line is trusted
// too far.
Colour irradiance_extrapolate(const IrradianceEstimate *estimate, Vec3 position, Vec3 normal);
