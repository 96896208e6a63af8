// What gather and gather_nanoflann share, so that both do the same work: photons on the walls of a box open to one
// side, query points in scan order, and the tally of a fixed-radius estimate. Plain C that is C++, too.
#pragma once

#include "bench_common.h"

#include <math.h>

enum { BENCH_K_COUNT = 3, BENCH_MAX_K = 1000 };
static const int bench_k[BENCH_K_COUNT] = {50, 100, 1000};

typedef struct {
    float position[3]; // m, in [-1, 1]³
    float wi[3];       // unit, to where the photon came from
    float power[3];    // W
} BenchPhoton;

typedef struct {
    float position[3];
    float normal[3];
    uint64_t order; // queries are sorted by this
} BenchQuery;

typedef struct {
    size_t photons, queries;
    int threads, repetitions;
} BenchArguments;

// How many queries to ask for k nearest: fewer of the large ones, which would take minutes.
static inline size_t bench_queries(const BenchArguments *arguments, int k)
{
    return k > 100 && arguments->queries > 100 ? arguments->queries / 50 : arguments->queries;
}

// A point on one of the five walls of [-1, 1]³, and the wall's normal into the box.
static inline void bench_wall_point(uint64_t *state, float position[3], float normal[3])
{
    static const float normals[5][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
    int wall = (int)(5.0f * bench_random(state));
    for (int axis = 0; axis < 3; axis++) {
        normal[axis] = normals[wall][axis];
        position[axis] = normal[axis] != 0.0f ? -normal[axis] : 2.0f * bench_random(state) - 1.0f;
    }
}

// One photon in eight arrives at the back of its wall. None grazes, so that rounding a direction changes no count.
static inline void bench_fill_photons(BenchPhoton *photons, size_t count)
{
    uint64_t state = 777;
    for (size_t i = 0; i < count; i++) {
        BenchPhoton *photon = &photons[i];
        float normal[3];
        bench_wall_point(&state, photon->position, normal);
        float side = bench_random(&state) < 0.125f ? -1.0f : 1.0f;
        float length2 = 0.0f;
        for (int axis = 0; axis < 3; axis++) {
            photon->wi[axis] = side * normal[axis] + 0.8f * (bench_random(&state) - 0.5f);
            photon->power[axis] = bench_random(&state);
            length2 += photon->wi[axis] * photon->wi[axis];
        }
        for (int axis = 0; axis < 3; axis++)
            photon->wi[axis] /= sqrtf(length2);
    }
}

static inline uint64_t bench_spread_bits(uint64_t x)
{
    uint64_t spread = 0;
    for (int bit = 0; bit < 10; bit++)
        spread |= (x >> bit & 1u) << (3 * bit);
    return spread;
}

static inline int bench_compare_queries(const void *a, const void *b)
{
    uint64_t left = ((const BenchQuery *)a)->order;
    uint64_t right = ((const BenchQuery *)b)->order;
    return left < right ? -1 : left > right;
}

// Neighbours in the list are neighbours in space, as the pixels of a tile are: sorted along a Morton curve.
// The last bits of the key are the point's number, for the same order from every qsort.
static inline void bench_fill_queries(BenchQuery *queries, size_t count)
{
    uint64_t state = 4242;
    for (size_t i = 0; i < count; i++) {
        BenchQuery *query = &queries[i];
        bench_wall_point(&state, query->position, query->normal);
        query->order = 0;
        for (int axis = 0; axis < 3; axis++)
            query->order |= bench_spread_bits((uint64_t)((query->position[axis] + 1.0f) * 511.99f)) << axis;
        query->order = query->order << 32 | i;
    }
    qsort(queries, count, sizeof *queries, bench_compare_queries);
}

// The radius (m) within which 50 photons are found on average, away from edges: the walls measure 20 m².
static inline float bench_radius(size_t photons)
{
    return sqrtf(50.0f * 20.0f / (3.14159265f * (float)photons));
}

static inline BenchArguments bench_arguments(int argc, char **argv)
{
    if (argc < 3 || argc > 5) {
        fprintf(stderr, "usage: %s PHOTONS THREADS [QUERIES] [REPETITIONS]\n", argv[0]);
        exit(1);
    }
    BenchArguments arguments;
    arguments.photons = (size_t)bench_number(argc, argv, 1, 0, 1000000000L);
    arguments.threads = (int)bench_number(argc, argv, 2, 1, 1024);
    arguments.queries = (size_t)bench_number(argc, argv, 3, 100000, 1000000000L);
    arguments.repetitions = (int)bench_number(argc, argv, 4, 5, 1000);
    return arguments;
}
