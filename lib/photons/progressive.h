// What progressive photon mapping keeps of a point that the eye sees: what stage 5 fills in and reads.
#pragma once

#include "math/colour.h"

// Floats alone: so it goes into files of passes.
typedef struct {
    float count;  // N: photons counted, of each pass the share α
    float radius; // R, m: photons nearer than this count
    Colour flux;  // τ: Σ f_r·Φ of the photons within R, over all passes, W/sr
} PointStatistics;
