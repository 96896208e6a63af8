// A point of the disk by rejection, lifted to the hemisphere; tangents by cross products.
#include "photonlab.h"

Vec3 scatter_diffuse(Vec3 normal, Rng *rng)
{
    float x = 1.0f, y = 1.0f;
    while (x * x + y * y >= 1.0f) {
        x = 2.0f * rng_float(rng) - 1.0f;
        y = 2.0f * rng_float(rng) - 1.0f;
    }
    float z = sqrtf(1.0f - x * x - y * y);
    Vec3 other = fabsf(normal.z) < 0.5f ? vec3(0.0f, 0.0f, 1.0f) : vec3(1.0f, 0.0f, 0.0f);
    Vec3 tangent = vec3_normalize(vec3_cross(other, normal));
    Vec3 bitangent = vec3_cross(normal, tangent);
    return vec3_along(vec3_along(vec3_scale(tangent, x), bitangent, y), normal, z);
}
