// Step 3.5: split white at its first refraction. Contract: lib/steps/3_colour_dispersion.h
#include "photonlab.h"

int split_colour(const Photon *photon, const Material *glass, Photon children[3])
{
    // BEGIN SOLUTION
    // 1. A coloured photon never splits again, and glass of one index splits nothing.
    if (photon->colour != WHITE || !glass->disperses) {
        children[0] = *photon;
        return 1;
    }

    // 2. Make three copies, each with one channel of the power, and that channel's colour.
    for (int c = 0; c < 3; c++) {
        children[c] = *photon;
        children[c].colour = (PhotonColour)(RED + c);
        children[c].power = colour_grey(0.0f);
        colour_set_channel(&children[c].power, c, colour_channel(photon->power, c));
    }
    return 3;
    // STUB: return 0;
    // END SOLUTION
}
