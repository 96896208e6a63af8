// What a PhotonTrace holds; students see only its name.
#pragma once

#include "photons/pass/photon_pass.h"

struct PhotonTrace {
    const Scene *scene;
    const PhotonPassOptions *options;

    StoredPhoton *photons; // what this chunk of paths has stored, in order
    size_t count, capacity;
    size_t caustics;                  // how many of them came by mirrors and glass only
    size_t first_caustic, first_rest; // where they go in the pass's arrays
    bool traced, out_of_memory;

    Ledger ledger;         // chance_error holds the sum of squares over paths until the pass ends
    double path_chance[3]; // the present path's part of ledger.chance
    uint64_t segments;
    UnsoundPaths unsound;
};

static inline void ledger_add_power(double sum[3], Colour power)
{
    sum[0] += (double)power.r;
    sum[1] += (double)power.g;
    sum[2] += (double)power.b;
}

// Probability and running sum by which a light is picked, in proportion to its power.
typedef struct {
    float probability, up_to;
} LightChance;

// One for each light, to be freed; NULL: no memory.
LightChance *light_chances(const Scene *scene);
size_t light_pick(const LightChance *chances, size_t count, Rng *rng);

// As light_emit, from the light as it is at one wavelength; of hero wavelengths the others follow by thirds of the range's share.
Photon light_emit_at_wavelength(const Light *light, double place, bool hero, Rng *rng);
