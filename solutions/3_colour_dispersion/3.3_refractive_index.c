// Step 3.3: the refractive index of a colour. Contract: lib/steps/3_colour_dispersion.h
#include "photonlab.h"

float refractive_index(const Material *glass, PhotonColour colour)
{
    // BEGIN SOLUTION
    // 1. Give each of the three colours the index of its own.
    switch (colour) {
    case RED:
        return glass->index[0];
    case GREEN:
        return glass->index[1];
    case BLUE:
        return glass->index[2];
    case WHITE:
        break;
    }

    // 2. Give white, which is all three at once, their mean.
    return (glass->index[0] + glass->index[1] + glass->index[2]) / 3.0f;
    // STUB: return 1.0f;
    // END SOLUTION
}
