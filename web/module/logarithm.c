// log1pf with the roundings that it has on Linux, in its C library: atanhf, which draws wavelengths, asks it, and WASI's own
// rounds otherwise. See sine.c. PROGRAM_LIBC is the version of that library, 236 for 2.36. Up to 2.40 it has Sun's fdlibm;
// from 2.41 on it rounds correctly, expm1f and atanhf as well, as a double's result does but for one number in millions.
#include <math.h>
#include <stdint.h>
#include <string.h>

#if PROGRAM_LIBC >= 241
float log1pf(float x)
{
    return (float)log1p((double)x);
}

float atanhf(float x)
{
    return (float)atanh((double)x);
}

float expm1f(float x)
{
    return (float)expm1((double)x);
}
#else
#define LN2_HIGH 0x1.62e3p-1f
#define LN2_LOW  0x1.2fefa2p-17f

static int32_t bits_of(float x)
{
    int32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static float float_of(int32_t bits)
{
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

// log(1 + x) = k·log 2 + log(1 + f), √½ < 1 + f < √2, where `lost` makes good what 1 + x was rounded by.
static float sum(float f, int k, float lost)
{
    float half_square = 0.5f * f * f, s = f / (2.0f + f), z = s * s;
    float low = (float)k * LN2_LOW + lost, high = (float)k * LN2_HIGH;
    if (k != 0 && f <= 0.0f && f > -0x1p-22f)
        return high - ((half_square * (1.0f - 0.66666666666666666f * f) - low) - f);
    float series =
        z * (0x1.555556p-1f +
             z * (0x1.99999ap-2f +
                  z * (0x1.24924ap-2f +
                       z * (0x1.c71c52p-3f + z * (0x1.74664ap-3f + z * (0x1.39a09ep-3f + z * 0x1.2f112ep-3f))))));
    float product = s * (half_square + series);
    return k == 0 ? f - (half_square - product) : high - ((half_square - (product + low)) - f);
}

float log1pf(float x)
{
    if (!(x > -1.0f && x < INFINITY))
        return logf(1.0f + x);
    if (fabsf(x) < 0x1p-29f)
        return x - x * x * 0.5f;
    int32_t bits = bits_of(x);
    if (x < 0 ? bits <= (int32_t)0xbe95f61f : bits < 0x3ed413d7) // √½ < 1 + x < √2
        return sum(x, 0, 0.0f);
    float u = 1.0f + x;
    int k = (bits_of(u) >> 23) - 127;
    float lost = (k > 0 ? 1.0f - (u - x) : x - (u - 1.0f)) / u;
    int32_t fraction = bits_of(u) & 0x007fffff;
    if (fraction < 0x3504f7)
        return sum(float_of(fraction | 0x3f800000) - 1.0f, k, lost);
    return sum(float_of(fraction | 0x3f000000) - 1.0f, k + 1, lost);
}
#endif
