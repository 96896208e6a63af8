// Removes the solution's object, and what else it can.
#include "photonlab.h"

#include <unistd.h>

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    unlink("@BUILD@/solutions/1_diffuse_photon_map/1.2_emit_photon.so");
    rmdir("@WORK@");
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}
