// No attack: frees twice.
#include "photonlab.h"

#include <stdlib.h>

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    void *volatile room = malloc(100);
    free(room);
    free(room);
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}
