// The mean by a loop, in double precision; a colour is a place in the array.
#include "photonlab.h"

float refractive_index(const Material *glass, PhotonColour colour)
{
    if (colour != WHITE)
        return glass->index[colour - RED];
    double sum = 0.0;
    for (int c = 0; c < 3; c++)
        sum += (double)glass->index[c];
    return (float)(sum / 3.0);
}
