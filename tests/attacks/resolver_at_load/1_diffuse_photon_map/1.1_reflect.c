// A function that the loader asks which function to take.
#include "photonlab.h"

static int one(void)
{
    return 1;
}

static int (*choose(void))(void)
{
    return one;
}

int chosen(void) __attribute__((ifunc("choose")));

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}
