// Step 3.5: split white at its first refraction. Contract: lib/steps/3_colour_dispersion.h
#include "photonlab.h"

int split_colour(const Photon *photon, const Material *glass, Photon children[3])
{
    todo("3.5"), (void)photon, (void)glass, (void)children; // take this line away when you start

    // 1. A coloured photon never splits again, and glass of one index splits nothing.

    // 2. Make three copies, each with one channel of the power, and that channel's colour.

    return 0;
}
