// Four floats at once, written as one (and eight where the processor has AVX): the compilers' vector types,
// so that + − × read as usual and compile for x86-64 and ARM alike. Only what those types lack is spelled out
// per processor here.
#pragma once

#include <math.h>
#include <stdint.h>
#include <string.h>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

typedef float Float4 __attribute__((vector_size(16)));
typedef int32_t Int4 __attribute__((vector_size(16))); // from comparisons: −1 true, 0 false

static inline Float4 float4_load(const void *from)
{
    Float4 lanes;
    memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

static inline Int4 int4_load(const uint32_t *from)
{
    Int4 lanes;
    memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

static inline Float4 float4_all(float x)
{
    return (Float4){x, x, x, x};
}

static inline Int4 int4_all(uint32_t x)
{
    int32_t i = (int32_t)x;
    return (Int4){i, i, i, i};
}

// Lane by lane a < b ? a : b, hence b where a is not a number; the tree's box test relies on that.
static inline Float4 float4_min(Float4 a, Float4 b)
{
#if defined(__SSE2__)
    return (Float4)_mm_min_ps((__m128)a, (__m128)b);
#else
    Int4 less = a < b;
    return (Float4)((less & (Int4)a) | (~less & (Int4)b));
#endif
}

static inline Float4 float4_max(Float4 a, Float4 b)
{
#if defined(__SSE2__)
    return (Float4)_mm_max_ps((__m128)a, (__m128)b);
#else
    Int4 more = a > b;
    return (Float4)((more & (Int4)a) | (~more & (Int4)b));
#endif
}

static inline Float4 float4_sqrt(Float4 a)
{
#if defined(__SSE2__)
    return (Float4)_mm_sqrt_ps((__m128)a);
#else
    return (Float4){sqrtf(a[0]), sqrtf(a[1]), sqrtf(a[2]), sqrtf(a[3])};
#endif
}

static inline Float4 float4_select(Int4 condition, Float4 yes, Float4 no)
{
    return (Float4)((condition & (Int4)yes) | (~condition & (Int4)no));
}

// Bit i of the result says whether lane i is true.
static inline unsigned int4_bits(Int4 mask)
{
#if defined(__SSE2__)
    return (unsigned)_mm_movemask_ps((__m128)mask);
#else
    Int4 bits = mask & (Int4){1, 2, 4, 8};
    return (unsigned)(bits[0] | bits[1] | bits[2] | bits[3]);
#endif
}

static inline uint32_t float_bits(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline float bits_float(uint32_t bits)
{
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

// As many lanes as one instruction of this processor takes, for the boxes of a node.
#if defined(__AVX2__)
#define LANES 8
typedef float Lanes __attribute__((vector_size(32)));
typedef int32_t LanesMask __attribute__((vector_size(32)));

#define lanes_all(x)         ((Lanes){x, x, x, x, x, x, x, x})
#define lanes_min(a, b)      ((Lanes)_mm256_min_ps((__m256)(a), (__m256)(b)))
#define lanes_max(a, b)      ((Lanes)_mm256_max_ps((__m256)(a), (__m256)(b)))
#define lanes_bits(mask)     ((unsigned)_mm256_movemask_ps((__m256)(mask)))
#define lanes_fours(from)    ((Lanes)_mm256_broadcast_ps((const __m128 *)(from)))    // the same four in both halves
#define lanes_pick(lanes, i) ((Lanes)_mm256_permute_ps((__m256)(lanes), (i) * 0x55)) // of each half, in all its lanes
#define lanes_bytes(from)    ((Lanes)_mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(_mm_loadl_epi64((const __m128i *)(from)))))
#else
#define LANES 4
typedef Float4 Lanes;
typedef Int4 LanesMask;

static inline Lanes lanes_bytes(const uint8_t *from)
{
#if defined(__SSE2__)
    int32_t bytes;
    memcpy(&bytes, from, sizeof bytes);
    __m128i zero = _mm_setzero_si128();
    return (Lanes)_mm_cvtepi32_ps(_mm_unpacklo_epi16(_mm_unpacklo_epi8(_mm_cvtsi32_si128(bytes), zero), zero));
#else
    return (Lanes){from[0], from[1], from[2], from[3]};
#endif
}

#define lanes_fours          float4_load
#define lanes_pick(lanes, i) float4_all((lanes)[i])
#define lanes_all            float4_all
#define lanes_min            float4_min
#define lanes_max            float4_max
#define lanes_bits           int4_bits
#endif

// a × b + c; whether it is rounded once or twice, the boxes leave room for.
#if defined(__AVX2__) && defined(__FMA__)
#define lanes_fma(a, b, c) ((Lanes)_mm256_fmadd_ps((__m256)(a), (__m256)(b), (__m256)(c)))
#else
#define lanes_fma(a, b, c) ((a) * (b) + (c))
#endif
