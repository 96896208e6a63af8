// Random numbers: PCG32 (O'Neill 2014), one stream per photon or pixel, so that every run gives the same numbers
// whatever the number of threads.
#pragma once

#include <stdint.h>

typedef struct {
    uint64_t state;
    uint64_t increment; // odd; tells the streams apart
} Rng;

// A 64-bit hash (the finaliser of SplitMix64, Steele et al. 2014): neighbouring inputs give unrelated outputs.
static inline uint64_t hash_u64(uint64_t x)
{
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

// The stream of number `index` under `seed`. State and increment are both hashed: PCG streams that differ in a
// small increment alone are correlated.
static inline Rng rng_create(uint64_t seed, uint64_t index)
{
    uint64_t h = hash_u64(seed ^ hash_u64(index));
    return (Rng){.state = h, .increment = hash_u64(h) | 1u};
}

static inline uint32_t rng_u32(Rng *rng)
{
    uint64_t old = rng->state;
    rng->state = old * 6364136223846793005u + rng->increment;
    uint32_t xorshifted = (uint32_t)(((old >> 18) ^ old) >> 27);
    uint32_t rotate = (uint32_t)(old >> 59);
    return (xorshifted >> rotate) | (xorshifted << ((32u - rotate) & 31u));
}

// Uniform in [0, 1): never 1, so that 1 − u is never 0. Draw one number per statement: the order in which a compiler
// evaluates two draws in one expression is its own choice.
static inline float rng_float(Rng *rng)
{
    return (float)(rng_u32(rng) >> 8) * (1.0f / 16777216.0f);
}
