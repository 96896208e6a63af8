// With fewer multiplications (Heckbert 1989).
#include "photonlab.h"

bool refract(Vec3 direction, Vec3 normal, float eta, Vec3 *refracted)
{
    float w = -eta * vec3_dot(normal, direction);
    float k = 1.0f + (w - eta) * (w + eta);
    bool through = k >= 0.0f;
    if (through) {
        float along = w - sqrtf(k);
        Vec3 t = vec3_add(vec3_scale(direction, eta), vec3_scale(normal, along));
        *refracted = vec3_scale(t, 1.0f / sqrtf(vec3_dot(t, t)));
    }
    return through;
}
