// Householder's matrix, I − 2nnᵀ, times the direction.
#include "photonlab.h"

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    const float n[3] = {normal.x, normal.y, normal.z};
    const float d[3] = {direction.x, direction.y, direction.z};
    float r[3];
    for (int row = 0; row < 3; row++) {
        r[row] = 0.0f;
        for (int column = 0; column < 3; column++) {
            float entry = (row == column ? 1.0f : 0.0f) - 2.0f * n[row] * n[column];
            r[row] += entry * d[column];
        }
    }
    return vec3(r[0], r[1], r[2]);
}
