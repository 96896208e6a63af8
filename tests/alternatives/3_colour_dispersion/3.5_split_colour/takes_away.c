// Copies the photon thrice, then takes from each copy what is not its own.
#include "photonlab.h"

int split_colour(const Photon *photon, const Material *glass, Photon children[3])
{
    for (int i = 0; i < 3; i++)
        children[i] = *photon;
    switch (photon->colour) {
    case RED:
    case GREEN:
    case BLUE:
        return 1;
    case WHITE:
        break;
    }
    if (!glass->disperses)
        return 1;
    children[0].power.g = children[0].power.b = 0.0f;
    children[1].power.r = children[1].power.b = 0.0f;
    children[2].power.r = children[2].power.g = 0.0f;
    for (int i = 0; i < 3; i++)
        children[i].colour = (PhotonColour)(RED + i);
    return 3;
}
