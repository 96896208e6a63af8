// Step 1.4: Russian roulette. Contract: lib/steps/1_diffuse_photon_map.h
#include "photonlab.h"

bool russian_roulette(Colour *power, Colour reflectance, Rng *rng)
{
    todo("1.4"), (void)power, (void)reflectance, (void)rng; // take this line away when you start

    // 1. Work out the flux before and after the bounce; their ratio is the probability to survive.

    // 2. Draw. Those who lose are absorbed.

    // 3. Let the survivors carry the flux of those who lost as well.

    return false;
}
