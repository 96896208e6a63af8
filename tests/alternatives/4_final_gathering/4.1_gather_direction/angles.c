// By the angles themselves, in double precision.
#include "photonlab.h"

Vec3 gather_direction(int ring, int sector, Rng *rng)
{
    double u = rng_float(rng);
    double v = rng_float(rng);
    double theta = asin(sqrt((ring + u) / GATHER_RINGS));
    double phi = 6.283185307179586 * (sector + v) / GATHER_SECTORS;
    return vec3((float)(sin(theta) * cos(phi)), (float)(sin(theta) * sin(phi)), (float)cos(theta));
}
