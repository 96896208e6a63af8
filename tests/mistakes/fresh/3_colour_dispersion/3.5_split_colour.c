//1 full_power          all of the power for each
//2 colour_not_set     the children stay white
//3 a_third            a third of the power for each
//4 splits_again       coloured photons split, too
//5 not_copied         nothing is filled in for the one
//6 -                  each child lacks its own channel
//11 mean_power       the mean of the channels
//12 only_one_returned  three are made
#include "photonlab.h"
int split_colour(const Photon *p, const Material *m, Photon out[3])
{
    static const PhotonColour names[3] = {RED, GREEN, BLUE};
    bool whole = !m->disperses || (p->colour != WHITE && MISTAKE != 4);
    if (whole && MISTAKE != 5)
        out[0] = *p;
    for (int i = 0; i < 3 && !whole; i++) {
        Photon child = *p;
        if (MISTAKE != 2)
            child.colour = names[i];
        Colour c = p->power;
        if (MISTAKE == 11)
            c = colour_grey((c.r + c.g + c.b) / 3.0f);
        if (MISTAKE == 3)
            child.power = colour_scale(c, 1.0f / 3.0f);
        else if (MISTAKE == 6)
            child.power = colour(i == 0 ? 0.0f : c.r, i == 1 ? 0.0f : c.g, i == 2 ? 0.0f : c.b);
        else if (MISTAKE != 1)
            child.power = colour(i == 0 ? c.r : 0.0f, i == 1 ? c.g : 0.0f, i == 2 ? c.b : 0.0f);
        out[i] = child;
    }
    return whole || MISTAKE == 12 ? 1 : 3;
}
