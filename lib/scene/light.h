// Light sources.
#ifndef PHOTONLAB_SCENE_LIGHT_H
#define PHOTONLAB_SCENE_LIGHT_H

#include "math/colour.h"
#include "math/ray.h"
#include "math/rng.h"

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
    uint32_t primitive;  // its surface in the scene; NO_PRIMITIVE for point, spot, beam
} Light;

// The light that reaches a point from one sampled spot of a source, were nothing in the way.
typedef struct {
    Vec3 wi;         // unit, from the point to the source
    float distance;  // to it, m (beam: to its disk)
    Colour arriving; // L·cosθ_light/(d²·pdf): the estimate of L_o is f_r·cosθ·arriving, the mean over samples
} LightSample;

// (u, v) in [0,1)². False when no light can come from there (behind a rectangle, outside a cone or beam).
bool light_sample(const Light *light, Vec3 point, float u, float v, LightSample *sample);

#endif
