// First the flux of one pass, then the area's share of it, in a loop over the channels.
#include "photonlab.h"

static const double pi = 3.14159265358979323846;

Colour point_radiance(PointStatistics point, int passes)
{
    double area = pi * pow((double)point.radius, 2.0);
    Colour radiance = colour_grey(0.0f);
    for (int c = 0; c < 3; c++) {
        double of_one_pass = (double)colour_channel(point.flux, c) / passes;
        colour_set_channel(&radiance, c, (float)(of_one_pass / area));
    }
    return radiance;
}
