// Threads and time. Without OpenMP everything runs on one thread.
#pragma once

// OMP(omp parallel): a pragma that is nothing without OpenMP.
#ifdef _OPENMP
#define OMP(...) _Pragma(#__VA_ARGS__)
#else
#define OMP(...)
#endif

// All cores when `wanted` is 0, otherwise what is wanted.
int parallel_threads(int wanted);

// The number of the calling thread, from 0.
int parallel_index(void);

// From now on everything that names no number of its own runs on this many threads (0: all cores).
void parallel_limit(int threads);

// Seconds of wall clock since some fixed time.
double clock_seconds(void);
