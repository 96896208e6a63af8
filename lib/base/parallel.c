#include "base/parallel.h"

#include <time.h>
#ifdef _OPENMP
#include <omp.h>
#else
#define omp_get_thread_num()       0
#define omp_set_num_threads(count) (void)(count)
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
    return omp_get_thread_num();
}

double clock_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void parallel_limit(int threads)
{
    omp_set_num_threads(parallel_threads(threads));
}
