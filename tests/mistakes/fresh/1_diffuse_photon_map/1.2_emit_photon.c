//1 same_number_twice   one random number for both sides
//2 wrong_side          leaves from the back
//3 factor|pi_missing              divided by π
//4 -                   the sides are brought to length 1
//5 corner              not spread at all
//6 position_as_centre  from minus a half to a half
//11 -                  random numbers squared
//12 uniform_hemisphere   even over the hemisphere
#include "photonlab.h"
Photon emit_photon(const Light *l, Rng *rng)
{
    Vec3 n = l->direction, a = l->edge_u, b = l->edge_v;
    float s = rng_float(rng);
    float t = MISTAKE == 1 ? s : rng_float(rng);
    if (MISTAKE == 4)
        a = vec3_normalize(a), b = vec3_normalize(b);
    if (MISTAKE == 5)
        s = t = 0.0f;
    if (MISTAKE == 6)
        s -= 0.5f, t -= 0.5f;
    if (MISTAKE == 11)
        s *= s, t *= t;
    Vec3 where = vec3_add(l->position, vec3_add(vec3_scale(a, s), vec3_scale(b, t)));
    if (MISTAKE == 2)
        n = vec3_negate(n);
    Vec3 way = steps.scatter_diffuse(n, rng);
    if (MISTAKE == 12) {
        do
            way = vec3(2.0f * rng_float(rng) - 1.0f, 2.0f * rng_float(rng) - 1.0f, 2.0f * rng_float(rng) - 1.0f);
        while (vec3_dot(way, way) > 1.0f || vec3_dot(way, n) <= 0.0f);
        way = vec3_normalize(way);
    }
    Colour power = l->power;
    if (MISTAKE == 3)
        power = colour_scale(power, 1.0f / PI);
    return photon_create(where, way, power);
}
