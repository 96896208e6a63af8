// Right, but counts its calls.
#include "photonlab.h"

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    static int count;
    count++;
    return vec3_along(direction, normal, count > 0 ? -2.0f * vec3_dot(direction, normal) : 0.0f);
}
