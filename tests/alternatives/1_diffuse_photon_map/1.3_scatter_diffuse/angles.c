// Through the angle itself: cos 2θ is uniform. Double precision, the azimuth drawn first.
#include "photonlab.h"

Vec3 scatter_diffuse(Vec3 normal, Rng *rng)
{
    double phi = 2.0 * (double)PI * (double)rng_float(rng);
    double theta = 0.5 * acos(1.0 - 2.0 * (double)rng_float(rng));
    Frame frame = frame_about(normal);
    Vec3 local = {(float)(cos(phi) * sin(theta)), (float)(sin(phi) * sin(theta)), (float)cos(theta)};
    return frame_to_world(&frame, local);
}
