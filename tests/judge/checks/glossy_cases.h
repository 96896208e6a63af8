// What steps 2.3 and 2.4 are called with.
#pragma once

#include "judge/checks/directions.h"

#define GLOSSY_CASES   12
#define GLOSSY_SAMPLES 12000
#define PHONG_FLOATS   5 // true, direction, weight
#define SOURCE_FLOATS  6 // the same, and how often redraw_cap_reached() was called

typedef struct {
    Vec3d direction, normal, mirror; // as the step gets the first two; unit
    double exponent, cos_in;         // cosine of the incident angle
    double above;                    // I_P
    char inputs[160];                // "n = 20, 60° to the normal (0, 0, 1)"
} GlossyCase;

GlossyCase glossy_case(int number); // from 0
void plan_glossy(Plan *plan);

// Density cosⁿα above the surface, 0 below; `input` is a GlossyCase.
double glossy_lobe(Vec3d d, const void *input);
