// One mirror that takes +z to the axis: lengths and angles stay, the hand changes.
#include "photonlab.h"

Vec3 turn_to(Vec3 local, Vec3 axis)
{
    Vec3 across = vec3_sub(axis, vec3(0.0f, 0.0f, 1.0f));
    float length2 = vec3_dot(across, across);
    if (length2 < 1e-12f)
        return local;
    float share = 2.0f * vec3_dot(local, across) / length2;
    return vec3_sub(local, vec3_scale(across, share));
}
