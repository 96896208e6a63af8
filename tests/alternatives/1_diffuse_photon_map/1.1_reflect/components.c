// Component by component, in double precision.
#include "photonlab.h"

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    double nx = normal.x, ny = normal.y, nz = normal.z;
    double twice = 2.0 * (direction.x * nx + direction.y * ny + direction.z * nz);
    return vec3((float)(direction.x - twice * nx), (float)(direction.y - twice * ny),
                (float)(direction.z - twice * nz));
}
