// The copy that came in is changed, the count last.
#include "photonlab.h"

PointStatistics add_photons(PointStatistics point, int found, Colour flux, float alpha)
{
    if (found > 0) {
        float m = (float)found;
        float shrink = sqrtf((point.count + alpha * m) / (point.count + m));
        point.radius *= shrink;
        point.flux = colour_add(point.flux, flux);
        point.flux = colour_scale(point.flux, shrink * shrink);
        point.count += alpha * m;
    }
    return point;
}
