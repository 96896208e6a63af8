// No attack: divides by 0.
#include "photonlab.h"

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    volatile int parts = 0;
    volatile int part = 7 / parts;
    direction.x = part > 0 ? direction.x : 0.0f;
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}
