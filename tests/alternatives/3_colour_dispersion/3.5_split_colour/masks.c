// Each child's power is the photon's seen through a filter.
#include "photonlab.h"

int split_colour(const Photon *photon, const Material *glass, Photon children[3])
{
    static const Colour filters[] = {{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
    int count = photon->colour == WHITE && glass->disperses ? 3 : 1;
    for (int i = 0; i < count; i++) {
        children[i] = *photon;
        if (count == 3) {
            children[i].power = colour_mul(photon->power, filters[i]);
            children[i].colour = (PhotonColour)(i + 1);
        }
    }
    return count;
}
