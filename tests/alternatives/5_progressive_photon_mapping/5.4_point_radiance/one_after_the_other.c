// By the radius, by it again, by π, by the passes.
#include "photonlab.h"

Colour point_radiance(PointStatistics point, int passes)
{
    Colour light = colour_scale(point.flux, 1.0f / point.radius);
    light = colour_scale(light, 1.0f / point.radius);
    light = colour_scale(light, 1.0f / PI);
    return colour_scale(light, 1.0f / (float)passes);
}
