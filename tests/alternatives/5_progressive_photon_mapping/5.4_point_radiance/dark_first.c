// Where no photon has been, there is no light.
#include "photonlab.h"

Colour point_radiance(PointStatistics point, int passes)
{
    Colour none = {0.0f, 0.0f, 0.0f};
    if (point.count <= 0.0f && colour_max(point.flux) <= 0.0f)
        return none;
    float per_area = 1.0f / (PI * point.radius * point.radius);
    return colour_scale(point.flux, per_area / (float)passes);
}
