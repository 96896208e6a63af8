// Prints without end.
#include "photonlab.h"

#include <stdio.h>

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    for (;;)
        puts("and so on");
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}
