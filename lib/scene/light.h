// Light sources.
#pragma once

#include "math/colour.h"
#include "math/ray.h"
#include "math/rng.h"
#include "scene/spectrum.h"

#include <stdbool.h>

typedef enum { LIGHT_RECTANGLE, LIGHT_SPHERE, LIGHT_POINT, LIGHT_SPOT, LIGHT_BEAM } LightType;

// power Φ (W) per channel: rectangle and sphere πAL; point 4πI; spot 2πI(1−cosθ_max), uniform inside its cone;
// beam: disk of radius R, parallel rays along `direction`, irradiance Φ/(πR²) across it.
typedef struct {
    LightType type;
    Vec3 position;       // rectangle: corner; sphere, point, spot, beam: centre
    Vec3 edge_u, edge_v; // rectangle: sides; edge_u × edge_v points where it shines. beam: unit vectors across it
    Vec3 direction;      // unit. rectangle: its normal; spot and beam: axis
    float radius;        // sphere, beam
    float cos_cone;      // spot: cosine of the half angle
    float area;          // rectangle, sphere (m²)
    Colour radiance;     // rectangle, sphere: L, W/(m²·sr), the same in all directions
    Colour power;        // Φ, W
    // With wavelengths: how the power that the file gives is spread over them (NULL: evenly), and the colours of the light behind
    // pure red, green and blue filters, in units of radiance, or of power where there is no surface.
    Spectrum *spectrum; // owned by the scene
    Colour given_power;
    Colour behind[3];
    uint32_t primitive; // its surface in the scene; NO_PRIMITIVE for point, spot, beam
} Light;

// The light that reaches a point from one sampled spot of a source, were nothing in the way.
typedef struct {
    Vec3 wi;         // unit, from the point to the source
    float distance;  // to it, m (beam: to its disk)
    float geometry;  // cosθ_light/(d²·pdf)
    Colour arriving; // L·geometry: the estimate of L_o is f_r·cosθ·arriving, the mean over samples
} LightSample;

// (u, v) in [0,1)². False when no light can come from there (behind a rectangle, outside a cone or beam).
bool light_sample(const Light *light, Vec3 point, float u, float v, LightSample *sample);

// Its power at a wavelength: in the mean over them given_power, as far as the spectrum leaves its colour.
float light_power_at(const Light *light, float wavelength);

// With wavelengths: what a surface of this BRDF makes of light that arrives by this geometry. A wall's three reflectances are
// not enough where a lamp's light is no white: sodium light has one hue on every wall.
Colour light_reflected(const Light *light, Colour brdf, float geometry);
