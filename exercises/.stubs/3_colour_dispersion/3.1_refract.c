// Step 3.1: refraction. Contract: lib/steps/3_colour_dispersion.h
#include "photonlab.h"

bool refract(Vec3 direction, Vec3 normal, float eta, Vec3 *refracted)
{
    todo("3.1"), (void)normal, (void)eta; // take this line away when you start

    // 1. Find cos²θ_t by Snell's law. Negative: no light gets through.

    // 2. Stretch the part along the surface by eta, and set the part along the normal to cosθ_t.

    // 3. Take away the rounding that many bounces would pile up.

    *refracted = direction;
    return true;
}
