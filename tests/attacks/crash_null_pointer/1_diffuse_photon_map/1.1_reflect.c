// No attack, but it dies like one: writes to nowhere.
#include "photonlab.h"

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    volatile float *volatile nowhere = NULL;
    *nowhere = direction.x;
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}
