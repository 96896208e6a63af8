// Calls itself without end.
#include "photonlab.h"

static float deeper(float x)
{
    volatile char room[256];
    room[0] = (char)x;
    return x + deeper(x + 1.0f) + (float)room[0];
}

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    return vec3_along(direction, normal, deeper(0.0f));
}
