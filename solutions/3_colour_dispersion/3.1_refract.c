// Step 3.1: refraction. Contract: lib/steps/3_colour_dispersion.h
#include "photonlab.h"

bool refract(Vec3 direction, Vec3 normal, float eta, Vec3 *refracted)
{
    // BEGIN SOLUTION
    // 1. Find cos²θ_t by Snell's law. Negative: no light gets through.
    float cos_i = -vec3_dot(direction, normal);
    float cos2_t = 1.0f - eta * eta * (1.0f - cos_i * cos_i);
    if (cos2_t < 0.0f)
        return false;

    // 2. Stretch the part along the surface by eta, and set the part along the normal to cosθ_t.
    Vec3 t = vec3_along(vec3_scale(direction, eta), normal, eta * cos_i - sqrtf(cos2_t));

    // 3. Take away the rounding that many bounces would pile up.
    *refracted = vec3_normalize(t);
    return true;
    // STUB: *refracted = direction;
    // STUB: return true;
    // END SOLUTION
}
