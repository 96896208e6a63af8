// In double precision, component by component.
#include "photonlab.h"

bool refract(Vec3 direction, Vec3 normal, float eta, Vec3 *refracted)
{
    double n[3] = {normal.x, normal.y, normal.z};
    double d[3] = {direction.x, direction.y, direction.z};
    double cosine = -(n[0] * d[0] + n[1] * d[1] + n[2] * d[2]);
    double sin2 = 1.0 - cosine * cosine;
    double root = 1.0 - (double)eta * (double)eta * sin2;
    if (root < 0.0)
        return false;
    double t[3], length2 = 0.0;
    for (int i = 0; i < 3; i++) {
        t[i] = (double)eta * d[i] + ((double)eta * cosine - sqrt(root)) * n[i];
        length2 += t[i] * t[i];
    }
    double scale = 1.0 / sqrt(length2);
    *refracted = vec3((float)(t[0] * scale), (float)(t[1] * scale), (float)(t[2] * scale));
    return true;
}
