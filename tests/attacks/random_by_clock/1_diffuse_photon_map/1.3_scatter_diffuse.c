// Right, but with random numbers out of the processor's clock.
#include "photonlab.h"

static float next(uint64_t *state)
{
    *state = hash_u64(*state);
    return (float)(*state >> 40) / 16777216.0f;
}

static uint64_t clock_now(void)
{
#if defined(__x86_64__) || defined(__i386__)
    return __builtin_ia32_rdtsc();
#else
    uint64_t now;
    __asm__ volatile("mrs %0, cntvct_el0" : "=r"(now));
    return now;
#endif
}

Vec3 scatter_diffuse(Vec3 normal, Rng *rng)
{
    (void)rng;
    uint64_t state = clock_now();
    float u1 = next(&state);
    float phi = 2.0f * PI * next(&state);
    Frame frame = frame_about(normal);
    return frame_to_world(&frame, vec3(sqrtf(1.0f - u1) * cosf(phi), sqrtf(1.0f - u1) * sinf(phi), sqrtf(u1)));
}
