// In double precision, by squared radii.
#include "photonlab.h"

PointStatistics add_photons(PointStatistics point, int found, Colour flux, float alpha)
{
    if (found <= 0)
        return point;
    double before = (double)point.radius * (double)point.radius;
    double count = (double)point.count + (double)alpha * found;
    double after = before * count / ((double)point.count + found);
    double ratio = after / before;
    PointStatistics next;
    next.count = (float)count;
    next.radius = (float)sqrt(after);
    next.flux.r = (float)(((double)point.flux.r + (double)flux.r) * ratio);
    next.flux.g = (float)(((double)point.flux.g + (double)flux.g) * ratio);
    next.flux.b = (float)(((double)point.flux.b + (double)flux.b) * ratio);
    return next;
}
