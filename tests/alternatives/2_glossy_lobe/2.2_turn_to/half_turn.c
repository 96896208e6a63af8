// Half a turn about the direction midway between +z and the axis.
#include "photonlab.h"

Vec3 turn_to(Vec3 local, Vec3 axis)
{
    double x = axis.x, y = axis.y, z = (double)axis.z + 1.0;
    double length2 = x * x + y * y + z * z;
    if (length2 < 1e-10) // straight down: any horizontal direction is midway
        return vec3(local.x, -local.y, -local.z);
    double twice = 2.0 * (x * local.x + y * local.y + z * local.z) / length2;
    return vec3((float)(twice * x - local.x), (float)(twice * y - local.y), (float)(twice * z - local.z));
}
