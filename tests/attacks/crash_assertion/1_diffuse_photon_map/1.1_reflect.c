// No attack: a student's own assertion.
#include "photonlab.h"

#include <assert.h>

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    assert(direction.x > 2.0f);
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}
