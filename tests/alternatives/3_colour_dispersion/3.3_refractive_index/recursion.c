// White asks for the three others.
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
    default: {
        float r = refractive_index(glass, RED);
        float g = refractive_index(glass, GREEN);
        float b = refractive_index(glass, BLUE);
        return r / 3.0f + g / 3.0f + b / 3.0f;
    }
    }
}
