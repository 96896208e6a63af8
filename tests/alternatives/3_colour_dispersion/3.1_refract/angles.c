// With angles: sinθ_t = η sinθ_i, in the plane of the direction and the normal.
#include "photonlab.h"

bool refract(Vec3 direction, Vec3 normal, float eta, Vec3 *refracted)
{
    Vec3 flat = vec3_along(direction, normal, -vec3_dot(direction, normal));
    double sin_i = vec3_length(flat);
    double sin_t = (double)eta * sin_i;
    if (sin_t > 1.0)
        return false;
    double theta_t = asin(sin_t);
    Vec3 down = vec3_scale(normal, -(float)cos(theta_t));
    *refracted = sin_i > 1e-7 ? vec3_along(down, flat, (float)(sin(theta_t) / sin_i)) : vec3_negate(normal);
    return true;
}
