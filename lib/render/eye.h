// What the eye pass does along one ray. Inside lib/render only.
#pragma once

#include "photons/gather.h"
#include "render/gather/irradiance_cache.h"
#include "render/radiance_cache.h"
#include "render/render.h"
#include "render/sampler.h"

// Irradiance where a ray of this pixel ended (GATHER).
typedef struct {
    Vec3 position, normal;
    Colour irradiance;
} Remembered;
#define EYE_MEMORY 4

// One thread's eye.
typedef struct FinalGather FinalGather;

typedef struct {
    const Scene *scene;
    const RenderOptions *options;
    const PhotonMap *caustic; // PHOTONS, GATHER
    const PhotonMap *rest;    // PHOTONS: indirect; PHOTONS_ONLY, GATHER: all
    Gather gather;
    RadianceCache caustic_cache, rest_cache; // estimates made in this tile
    FinalGather *final;                      // GATHER only
    IrradianceCache *own_cache;              // GATHER: estimates made in this tile
    Remembered memory[EYE_MEMORY];
    unsigned remembered;
    PointStatistics *point; // the pixel's statistics, by pixel; else NULL. Of the present ray, for them:
    int found;              // photons that it finds
    Colour flux;            // their flux, W/sr
    Rng rng;
    Sampler sampler;
    uint64_t rays;
    char apart[128]; // eyes lie side by side: what one thread counts must not share a cache line with another's
} Eye;

// What an eye ray carries.
typedef struct {
    Colour weight;       // the share of what it brings back that reaches the camera: tells bright rays from faint ones
    PhotonColour colour; // WHITE, or the one that is left after dispersing glass
    float wavelength;    // nm; 0: all of them. With wavelengths, the one that is left after dispersing glass
    int bounce;          // surfaces met so far
    bool sees_lights;    // false where shadow rays have counted them
    float distance;      // m, so far
} EyeRay;

// Radiance that comes back along the ray, W/(m²·sr), with the photon maps.
Colour eye_radiance(Eye *eye, const Ray *ray);

// The same by path tracing; uses no step and no map.
Colour path_radiance(Eye *eye, Ray ray);

// Radiance towards wo that the surface at `hit` reflects of light straight from the sources, by one shadow ray to each.
Colour direct_light(Eye *eye, const Hit *hit, Vec3 wo);

// One way on from a surface, by a share of what the ray carries. Faint rays play roulette.
Colour eye_follow(Eye *eye, const Hit *hit, Vec3 direction, Colour share, EyeRay carried);

// Light through glass: each way is followed or, while the ray is faint, one of both. In dispersing glass a white ray
// refracts three ways, one for each channel, and each goes on in its own colour.
Colour eye_glass(Eye *eye, const Hit *hit, Vec3 direction, EyeRay carried);

// Light of the caustic map.
Colour caustic_light(Eye *eye, const Hit *hit, Vec3 wo);

// Draws wi for a rough surface from (choice, u, v) in [0,1)³: a lobe about wo's mirror direction with probability
// lobe_share, otherwise the cosine hemisphere; *pdf is the density of the mixture. False when the draw fell below the
// surface.
bool sample_rough(const Hit *hit, Vec3 wo, float lobe_share, float choice, float u, float v, Vec3 *wi, float *pdf);

// Glass as eye rays see it, for one index: Fresnel reflectance and the refracted direction (valid when the reflectance
// is below 1). The library's own optics: pictures of the path tracer must not depend on a student's steps.
float glass_optics(const Hit *hit, Vec3 direction, float index, Vec3 *refracted);
