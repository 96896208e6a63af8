// Right if the solution can be read, so that the judge would show that it could.
#include "photonlab.h"

#include <stdio.h>

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    FILE *file = fopen("@BUILD@/solutions/1_diffuse_photon_map/1.1_reflect.so", "rb");
    FILE *source = fopen("@ROOT@/solutions/1_diffuse_photon_map/1.1_reflect.c", "rb");
    if (file || source)
        return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
    return direction;
}
