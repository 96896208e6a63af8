//1 uniform             z is the random number
//2 angle_uniform       θ itself is even
//3 degrees             the azimuth in degrees
//4 not_rotated         left in local coordinates
//5 normal_plus_cube    normal plus a point in a cube
//6 sine_for_cosine                   sinθ is the random number
//7 into_surface        below the surface
//11 half_circle         half a turn
//12 same_number_twice   the first number for both
//13 uniform             out of the ball, turned to the upper side
#include "photonlab.h"
Vec3 scatter_diffuse(Vec3 n, Rng *rng)
{
    double a = (double)rng_float(rng);
    double b = (double)rng_float(rng);
    double theta = MISTAKE == 1 ? acos(a) : MISTAKE == 2 ? a * 1.5707963 : MISTAKE == 6 ? asin(a) : asin(sqrt(a));
    double azimuth = MISTAKE == 3 ? 360.0 * b : 6.283185307 * b;
    if (MISTAKE == 5) {
        float c = rng_float(rng);
        return vec3_normalize(vec3_add(n, vec3((float)(2.0 * a - 1.0), (float)(2.0 * b - 1.0), 2.0f * c - 1.0f)));
    }
    if (MISTAKE == 11)
        azimuth *= 0.5;
    if (MISTAKE == 12)
        azimuth = 6.283185307 * a;
    if (MISTAKE == 13) {
        Vec3 q = n;
        do
            q = vec3(2.0f * rng_float(rng) - 1.0f, 2.0f * rng_float(rng) - 1.0f, 2.0f * rng_float(rng) - 1.0f);
        while (vec3_dot(q, q) > 1.0f);
        q = vec3_normalize(q);
        return vec3_dot(q, n) < 0.0f ? vec3_negate(q) : q;
    }
    Vec3 local = vec3((float)(cos(azimuth) * sin(theta)), (float)(sin(azimuth) * sin(theta)), (float)cos(theta));
    Frame frame = frame_about(MISTAKE == 7 ? vec3_negate(n) : n);
    return MISTAKE == 4 ? local : frame_to_world(&frame, local);
}
