// No attack: a function that nobody can call.
#define reflect reflect_elsewhere
#include "photonlab.h"
#undef reflect

__attribute__((used)) static Vec3 reflect(Vec3 direction, Vec3 normal)
{
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}
