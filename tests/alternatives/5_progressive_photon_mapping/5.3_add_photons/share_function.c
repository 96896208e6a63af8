// A function for the share, which is 1 where nothing was found, and old and new flux apart.
#include "photonlab.h"

static float area_share(float count, float found, float alpha)
{
    return found > 0.0f ? 1.0f - found * (1.0f - alpha) / (count + found) : 1.0f;
}

PointStatistics add_photons(PointStatistics point, int found, Colour flux, float alpha)
{
    const float share = area_share(point.count, (float)found, alpha);
    Colour old = colour_scale(point.flux, share);
    Colour added = found > 0 ? colour_scale(flux, share) : colour_grey(0.0f);
    float count = fmaf(alpha, (float)found, point.count);
    return (PointStatistics){count, sqrtf(share) * point.radius, colour_add(old, added)};
}
