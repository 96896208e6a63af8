// A constructor that the compiler knows nothing of.
#include "photonlab.h"

static void before_all(void)
{
}

__asm__(".section .init_array,\"aw\"\n.quad 0\n.text\n");
void (*const kept)(void) = before_all;

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}
