// Step 1.1: the mirror direction. Contract: lib/steps/1_diffuse_photon_map.h
#include "photonlab.h"

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    // BEGIN SOLUTION
    // 1. Find how far `direction` goes along the normal.
    float along = vec3_dot(direction, normal);

    // 2. Take that part away twice: once to lie in the surface, once more to come out mirrored.
    return vec3_along(direction, normal, -2.0f * along);
    // STUB: return direction;
    // END SOLUTION
}
