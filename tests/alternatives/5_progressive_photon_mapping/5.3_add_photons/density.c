// As the text has it: the density of photons stays, so that those who are left have their disk.
#include "photonlab.h"

PointStatistics add_photons(PointStatistics point, int found, Colour flux, float alpha)
{
    float all = point.count + (float)found;
    if (all == point.count)
        return point;
    float old_square = point.radius * point.radius;
    float density = all / (PI * old_square);
    PointStatistics next = {.count = point.count + alpha * (float)found};
    float new_square = next.count / (PI * density);
    next.radius = sqrtf(new_square);
    next.flux = colour_scale(colour_add(point.flux, flux), new_square / old_square);
    return next;
}
