// The three children one after the other.
#include "photonlab.h"

int split_colour(const Photon *photon, const Material *glass, Photon children[3])
{
    bool splits = photon->colour == WHITE && glass->disperses;
    children[0] = *photon;
    if (!splits)
        return 1;
    children[1] = *photon;
    children[2] = *photon;
    children[0].colour = RED;
    children[1].colour = GREEN;
    children[2].colour = BLUE;
    children[0].power = colour(photon->power.r, 0.0f, 0.0f);
    children[1].power = colour(0.0f, photon->power.g, 0.0f);
    children[2].power = colour(0.0f, 0.0f, photon->power.b);
    return 3;
}
