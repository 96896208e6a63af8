// An array that no stack holds.
#include "photonlab.h"

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    volatile char room[100 << 20];
    for (size_t i = 0; i < sizeof room; i += 4096)
        room[i] = 1;
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}
