// Step 3.3: the refractive index of a colour. Contract: lib/steps/3_colour_dispersion.h
#include "photonlab.h"

float refractive_index(const Material *glass, PhotonColour colour)
{
    todo("3.3"), (void)glass, (void)colour; // take this line away when you start

    // 1. Give each of the three colours the index of its own.

    // 2. Give white, which is all three at once, their mean.

    return 1.0f;
}
