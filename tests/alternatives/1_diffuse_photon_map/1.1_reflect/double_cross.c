// Two cross products: n × (n × d) is minus the part along the surface.
#include "photonlab.h"

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    Vec3 minus_flat = vec3_cross(normal, vec3_cross(normal, direction));
    Vec3 twice_flat = vec3_scale(minus_flat, -2.0f);
    return vec3_sub(twice_flat, direction);
}
