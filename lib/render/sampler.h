// Well-spread numbers for the samples of one pixel: the (0,2)-sequence of van der Corput and Sobol', scrambled per
// pixel and dimension (Kollig & Keller 2002). Any power-of-two run of samples is stratified in both coordinates at
// once.
#pragma once

#include "math/rng.h"

typedef struct {
    uint64_t pixel; // hash of seed and pixel
    uint32_t index; // which sample of the pixel
} Sampler;

static inline uint32_t bits_reversed(uint32_t x)
{
    x = x << 16 | x >> 16;
    x = (x & 0x00ff00ffu) << 8 | (x & 0xff00ff00u) >> 8;
    x = (x & 0x0f0f0f0fu) << 4 | (x & 0xf0f0f0f0u) >> 4;
    x = (x & 0x33333333u) << 2 | (x & 0xccccccccu) >> 2;
    return (x & 0x55555555u) << 1 | (x & 0xaaaaaaaau) >> 1;
}

static inline uint32_t sobol_second(uint32_t x)
{
    uint32_t result = 0;
    for (uint32_t v = 1u << 31; x; x >>= 1, v ^= v >> 1)
        if (x & 1u)
            result ^= v;
    return result;
}

// Another order of the samples: each block of 2, 4, 8 … stays together (Laine & Karras 2011, as Burley 2020 uses it).
static inline uint32_t shuffled(uint32_t index, uint32_t seed)
{
    uint32_t x = bits_reversed(index) + seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return bits_reversed(x);
}

// The sampler's point in [0,1)² for one use (the film, light 0, light 1, …); each use is scrambled by itself.
static inline void sampler_point(const Sampler *sampler, uint32_t use, float *u, float *v)
{
    uint64_t scramble = hash_u64(sampler->pixel + use);
    uint32_t index = use ? shuffled(sampler->index, (uint32_t)(hash_u64(scramble) >> 32)) : sampler->index;
    *u = (float)((bits_reversed(index) ^ (uint32_t)scramble) >> 8) * (1.0f / 16777216.0f);
    *v = (float)((sobol_second(index) ^ (uint32_t)(scramble >> 32)) >> 8) * (1.0f / 16777216.0f);
}

#define SAMPLER_FILM  0u
#define SAMPLER_LIGHT 1u       // and upwards: one use per light
#define SAMPLER_LOBE  1000000u // and upwards: one use per bounce
#define SAMPLER_WAVE  2000000u // the wavelength behind dispersing glass
