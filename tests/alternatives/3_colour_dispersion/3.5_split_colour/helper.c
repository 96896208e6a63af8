// One helper makes one child.
#include "photonlab.h"

static Photon child_of(const Photon *parent, PhotonColour band, float r, float g, float b)
{
    Photon child = *parent;
    child.colour = band;
    child.power.r = r;
    child.power.g = g;
    child.power.b = b;
    return child;
}

int split_colour(const Photon *photon, const Material *glass, Photon children[3])
{
    Colour power = photon->power;
    if (glass->disperses && photon->colour == WHITE) {
        children[2] = child_of(photon, BLUE, 0.0f, 0.0f, power.b);
        children[1] = child_of(photon, GREEN, 0.0f, power.g, 0.0f);
        children[0] = child_of(photon, RED, power.r, 0.0f, 0.0f);
        return 3;
    }
    *children = *photon;
    return 1;
}
