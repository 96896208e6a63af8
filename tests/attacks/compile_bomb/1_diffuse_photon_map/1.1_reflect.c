// A compiler that is kept busy with a table that it has to write out.
#include "photonlab.h"

const char table[1u << 31] = {1};

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}
