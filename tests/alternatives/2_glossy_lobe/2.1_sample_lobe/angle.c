// Through the angle itself, in double precision; the azimuth drawn first.
#include "photonlab.h"

Vec3 sample_lobe(float exponent, Rng *rng)
{
    double phi = 2.0 * (double)PI * (double)rng_float(rng);
    double u = 1.0 - (double)rng_float(rng);
    double alpha = acos(pow(u, 1.0 / ((double)exponent + 1.0)));
    Vec3 d;
    d.x = (float)(sin(alpha) * cos(phi));
    d.y = (float)(sin(alpha) * sin(phi));
    d.z = (float)cos(alpha);
    return d;
}
