// Step 3.3: the refractive index of a colour. Contract: lib/steps/3_colour_dispersion.h
#include "photonlab.h"

float refractive_index(const Material *glass, PhotonColour colour)
{
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
    return (glass->index[0] + glass->index[1] + glass->index[2]) / 3.0f;
}
