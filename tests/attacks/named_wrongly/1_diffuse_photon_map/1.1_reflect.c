// No attack: a slip.
#include "photonlab.h"

Vec3 reflekt(Vec3 direction, Vec3 normal)
{
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}
