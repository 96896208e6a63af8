// In double precision, channel by channel.
#include "photonlab.h"

Colour point_radiance(PointStatistics point, int passes)
{
    double r = (double)point.radius;
    double share = acos(-1.0) * r * r * passes;
    return colour((float)((double)point.flux.r / share), (float)((double)point.flux.g / share),
                  (float)((double)point.flux.b / share));
}
