// Leans by the axis' angle to z, then turns by its azimuth.
#include "photonlab.h"

Vec3 turn_to(Vec3 local, Vec3 axis)
{
    float sin_lean = hypotf(axis.x, axis.y);
    float cos_lean = axis.z;
    float cos_turn = sin_lean > 0.0f ? axis.x / sin_lean : 1.0f;
    float sin_turn = sin_lean > 0.0f ? axis.y / sin_lean : 0.0f;
    float x = local.x * cos_lean + local.z * sin_lean;
    float y = local.y;
    float z = local.z * cos_lean - local.x * sin_lean;
    return vec3(x * cos_turn - y * sin_turn, x * sin_turn + y * cos_turn, z);
}
