//1 tangent_not_normalised   the cross product as it is
//2 fails_at_z               the helper is always z
//3 y_missing                y is forgotten
//4 below                    the other way along the axis
//5 -                        the helper is not made perpendicular
#include "photonlab.h"
Vec3 turn_to(Vec3 v, Vec3 w)
{
    Vec3 up = fabsf(w.z) < 0.9f || MISTAKE == 2 ? (Vec3){0.0f, 0.0f, 1.0f} : (Vec3){1.0f, 0.0f, 0.0f};
    Vec3 s = vec3_cross(up, w);
    if (MISTAKE == 5)
        s = up;
    if (MISTAKE != 1)
        s = vec3_normalize(s);
    Vec3 t = vec3_cross(w, s);
    float y = MISTAKE == 3 ? 0.0f : v.y, z = MISTAKE == 4 ? -v.z : v.z;
    return vec3(v.x * s.x + y * t.x + z * w.x, v.x * s.y + y * t.y + z * w.y, v.x * s.z + y * t.z + z * w.z);
}
