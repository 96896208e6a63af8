// Right, but with random numbers of the C library's, called by another name.
#include "photonlab.h"

#if defined(__x86_64__)
__asm__(".symver dice, rand@GLIBC_2.2.5");
#else
__asm__(".symver dice, rand@GLIBC_2.17");
#endif
int dice(void);

static float next(void)
{
    return (float)dice() / 2147483648.0f;
}

Vec3 scatter_diffuse(Vec3 normal, Rng *rng)
{
    (void)rng;
    float u1 = next();
    float phi = 2.0f * PI * next();
    Frame frame = frame_about(normal);
    return frame_to_world(&frame, vec3(sqrtf(1.0f - u1) * cosf(phi), sqrtf(1.0f - u1) * sinf(phi), sqrtf(u1)));
}
