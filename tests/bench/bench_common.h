// What all programs of the bench share: clock, medians, numbers. Plain C that is C++, too.
#pragma once

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static inline double bench_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

// SplitMix64 (Steele et al. 2014).
static inline float bench_random(uint64_t *state)
{
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (float)((z ^ (z >> 31)) >> 40) * (1.0f / 16777216.0f);
}

static inline int bench_compare_doubles(const void *a, const void *b)
{
    double left = *(const double *)a;
    double right = *(const double *)b;
    return left < right ? -1 : left > right;
}

static inline double bench_median(double *values, int count)
{
    qsort(values, (size_t)count, sizeof *values, bench_compare_doubles);
    return values[count / 2];
}

static inline long bench_number(int argc, char **argv, int place, long otherwise, long most)
{
    if (place >= argc)
        return otherwise;
    char *end;
    long value = strtol(argv[place], &end, 10);
    if (*end || value < 1 || value > most) {
        fprintf(stderr, "%s: %s: expected a number from 1 to %ld\n", argv[0], argv[place], most);
        exit(1);
    }
    return value;
}

static inline void *bench_allocate(size_t count, size_t size)
{
    void *memory = calloc(count, size);
    if (!memory) {
        fprintf(stderr, "no memory for %zu × %zu bytes\n", count, size);
        exit(1);
    }
    return memory;
}
