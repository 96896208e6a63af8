#include "photonlab.h"

float refractive_index(const Material *glass, PhotonColour colour)
{
    const float *n = glass->index;
    if (colour == WHITE)
        return (n[0] + n[1] + n[2]) / 3.0f;
    if (colour == RED)
        return n[0];
    return colour == GREEN ? n[1] : n[2];
}
