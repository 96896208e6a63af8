// The part along the surface first, then what the unit length leaves for the part along the normal.
#include "photonlab.h"

bool refract(Vec3 direction, Vec3 normal, float eta, Vec3 *refracted)
{
    float c = vec3_dot(direction, normal);
    Vec3 flat = vec3_scale(vec3_sub(direction, vec3_scale(normal, c)), eta);
    float left = 1.0f - vec3_dot(flat, flat);
    if (left < 0.0f)
        return false;
    *refracted = vec3_sub(flat, vec3_scale(normal, sqrtf(left)));
    return true;
}
