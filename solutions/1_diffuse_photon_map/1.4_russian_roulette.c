// Step 1.4: Russian roulette. Contract: lib/steps/1_diffuse_photon_map.h
#include "photonlab.h"

bool russian_roulette(Colour *power, Colour reflectance, Rng *rng)
{
    // BEGIN SOLUTION
    // 1. Work out the flux before and after the bounce; their ratio is the probability to survive.
    Colour reflected = colour_mul(*power, reflectance);
    float before = colour_sum(*power);
    float survival = before > 0.0f ? fminf(1.0f, colour_sum(reflected) / before) : 0.0f;

    // 2. Draw. Those who lose are absorbed.
    if (rng_float(rng) >= survival)
        return false;

    // 3. Let the survivors carry the flux of those who lost as well.
    *power = colour_scale(reflected, 1.0f / survival);
    return true;
    // STUB: return false;
    // END SOLUTION
}
