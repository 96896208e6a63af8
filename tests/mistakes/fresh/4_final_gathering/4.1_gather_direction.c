//1 uniform_hemisphere       even solid angles
//2 swapped                  ring and sector
//3 cell_corner              no chance in it
//4 cosine_root_missing      z is cos²
//5 -                        rings drawn twice as wide
//11 half_circle              half a turn
//12 same_number_twice         one number for both
//13 angle_uniform             even angles
#include "photonlab.h"
Vec3 gather_direction(int j, int k, Rng *rng)
{
    float a = rng_float(rng);
    float b = rng_float(rng);
    if (MISTAKE == 12)
        b = a;
    if (MISTAKE == 3)
        a = b = 0.0f;
    float s = (j + (MISTAKE == 5 ? 2.0f * a - 0.5f : a)) / GATHER_RINGS, f = (k + b) / GATHER_SECTORS;
    if (MISTAKE == 11)
        f *= 0.5f;
    if (MISTAKE == 13)
        s = powf(sinf(0.5f * PI * s), 2.0f);
    if (MISTAKE == 2)
        s = (k + b) / GATHER_SECTORS, f = (j + a) / GATHER_RINGS;
    s = fminf(fmaxf(s, 0.0f), 1.0f);
    float z = MISTAKE == 1 ? 1.0f - s : sqrtf(1.0f - s), r = MISTAKE == 1 ? sqrtf(1.0f - z * z) : sqrtf(s);
    return (Vec3){r * cosf(2.0f * PI * f), r * sinf(2.0f * PI * f), MISTAKE == 4 ? 1.0f - s : z};
}
