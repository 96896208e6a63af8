// The part along the surface stays, the part along the normal turns round.
#include "photonlab.h"

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    Vec3 upright = vec3_scale(normal, vec3_dot(normal, direction));
    Vec3 flat = vec3_sub(direction, upright);
    return vec3_sub(flat, upright);
}
