// Irradiance as final gathering estimates it: what stage 4 fills in and reads.
#pragma once

#include "math/colour.h"
#include "math/vec3.h"

// One gather ray a cell: rings from the normal outwards, sectors about it.
#define GATHER_RINGS   12
#define GATHER_SECTORS 36

// What the rays over one point have found.
typedef struct {
    Colour radiance[GATHER_RINGS][GATHER_SECTORS]; // W/(m²·sr)
    float distance[GATHER_RINGS][GATHER_SECTORS];  // to the first surface, m; INFINITY: the open
} Hemisphere;

// An estimate, and how far it may be used.
typedef struct {
    Vec3 position, normal;
    Colour irradiance;   // W/m²
    float reach;         // R, m
    Vec3 translation[3]; // how each channel changes along the surface, W/m³,
    Vec3 rotation[3];    // and as the normal turns, W/m² a radian; for use as (n_i × n)·rotation (Ward & Heckbert 1992)
} IrradianceEstimate;

// One thread's gather rays; see render/gather/gather_trace.h, whose calls take it.
typedef struct GatherTrace GatherTrace;
