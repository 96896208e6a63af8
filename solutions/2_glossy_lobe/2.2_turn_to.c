// Step 2.2: turn a direction from +z to an axis. Contract: lib/steps/2_glossy_lobe.h
#include "photonlab.h"

Vec3 turn_to(Vec3 local, Vec3 axis)
{
    // BEGIN SOLUTION
    // 1. Find two unit vectors at right angles to the axis and to each other: start from whichever of x and y is
    // farther from it.
    Vec3 helper = fabsf(axis.x) < 0.7f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
    Vec3 tangent = vec3_normalize(vec3_cross(helper, axis));
    Vec3 bitangent = vec3_cross(axis, tangent);

    // 2. Go as far along each of the three as `local` goes along x, y and z.
    Vec3 turned = vec3_scale(tangent, local.x);
    turned = vec3_along(turned, bitangent, local.y);
    return vec3_along(turned, axis, local.z);
    // STUB: return axis;
    // END SOLUTION
}
