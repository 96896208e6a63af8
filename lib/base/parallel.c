#include "base/parallel.h"

#include <time.h>
#ifdef _OPENMP
#include <omp.h>
#endif

int parallel_threads(int wanted)
{
#ifdef _OPENMP
    return wanted > 0 ? wanted : omp_get_num_procs();
#else
    (void)wanted;
    return 1;
#endif
}

int parallel_index(void)
{
#ifdef _OPENMP
    return omp_get_thread_num();
#else
    return 0;
#endif
}

double clock_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void parallel_limit(int threads)
{
#ifdef _OPENMP
    omp_set_num_threads(parallel_threads(threads));
#else
    (void)threads;
#endif
}
