// How fast the photon map is built and asked.
//   gather PHOTONS THREADS [QUERIES] [REPETITIONS]   "key value" lines, medians; compare with gather_nanoflann
#include "gather_common.h"
#include "photons/photon_map.h"

#include <omp.h>
#include <string.h>

typedef struct {
    PhotonMap *map;
    const BenchQuery *queries;
    size_t query_count;
    size_t k;     // for nearest
    float radius; // for the others
} Work;

typedef struct {
    double r2, found, power; // sums over all queries: to see that peers did the same
} Sums;

typedef Sums (*Measure)(const Work *work, size_t query, NearPhoton *near);

static Vec3 from_array(const float v[3])
{
    return vec3(v[0], v[1], v[2]);
}

static Sums measure_nearest(const Work *work, size_t query, NearPhoton *near)
{
    float r2 = INFINITY;
    size_t found = photon_map_nearest(work->map, from_array(work->queries[query].position), work->k, &r2, near);
    return (Sums){(double)r2, (double)found, 0.0};
}

// Cone filter (Jensen 1996) and side test, as in an estimate of fixed radius.
static Sums measure_within(const Work *work, size_t query, NearPhoton *near)
{
    const BenchQuery *at = &work->queries[query];
    Vec3 normal = from_array(at->normal);
    Colour sum = {0};
    float per_radius = 1.0f / work->radius;
    float r2 = work->radius * work->radius;
    size_t found = photon_map_nearest(work->map, from_array(at->position), BENCH_MAX_K, &r2, near);
    for (size_t i = 0; i < found; i++)
        if (stored_photon_on_side(near[i].photon, normal)) {
            float weight = 1.0f - sqrtf(near[i].distance2) * per_radius;
            sum = colour_add(sum, colour_scale(near[i].photon->power, weight));
        }
    return (Sums){0.0, (double)found, (double)colour_sum(sum)};
}

// Thousand queries a second, the median of all repetitions.
static double rate(const Work *work, int repetitions, Measure measure, Sums *sums)
{
    double *seconds = bench_allocate((size_t)repetitions, sizeof *seconds);
    for (int repetition = 0; repetition < repetitions; repetition++) {
        double r2 = 0.0, found = 0.0, power = 0.0;
        double start = bench_seconds();
#pragma omp parallel reduction(+ : r2, found, power)
        {
            NearPhoton *near = bench_allocate(PHOTON_MAP_NEAREST_CAPACITY(BENCH_MAX_K), sizeof *near);
#pragma omp for schedule(static)
            for (size_t i = 0; i < work->query_count; i++) {
                Sums one = measure(work, i, near);
                r2 += one.r2;
                found += one.found;
                power += one.power;
            }
            free(near);
        }
        seconds[repetition] = bench_seconds() - start;
        *sums = (Sums){r2, found, power};
    }
    double median = bench_median(seconds, repetitions);
    free(seconds);
    return 1e-3 * (double)work->query_count / median;
}

static StoredPhoton *make_photons(size_t count)
{
    BenchPhoton *plain = bench_allocate(count, sizeof *plain);
    StoredPhoton *photons = bench_allocate(count, sizeof *photons);
    bench_fill_photons(plain, count);
    for (size_t i = 0; i < count; i++) {
        photons[i].position = from_array(plain[i].position);
        photons[i].power = colour(plain[i].power[0], plain[i].power[1], plain[i].power[2]);
        photons[i].packed_wi = direction_pack(from_array(plain[i].wi));
    }
    free(plain);
    return photons;
}

// Builds from a copy, `repetitions` times; returns the last map and the median of million photons a second.
static PhotonMap *time_build(const StoredPhoton *photons, size_t count, int repetitions, double *mpoints_s)
{
    PhotonMap *map = NULL;
    double *seconds = bench_allocate((size_t)repetitions, sizeof *seconds);
    for (int repetition = 0; repetition < repetitions; repetition++) {
        photon_map_free(map);
        StoredPhoton *copy = bench_allocate(count, sizeof *copy);
        memcpy(copy, photons, count * sizeof *copy);
        Error error = {{0}};
        double start = bench_seconds();
        map = photon_map_build(copy, count, &error);
        seconds[repetition] = bench_seconds() - start;
        if (!map) {
            fprintf(stderr, "%s\n", error.message);
            exit(1);
        }
    }
    *mpoints_s = 1e-6 * (double)count / bench_median(seconds, repetitions);
    free(seconds);
    return map;
}

static void print_measures(Work *work, const BenchArguments *arguments)
{
    int repetitions = arguments->repetitions;
    double queries = (double)arguments->queries;
    Sums sums;
    for (int i = 0; i < BENCH_K_COUNT; i++) {
        work->k = (size_t)bench_k[i];
        work->query_count = bench_queries(arguments, bench_k[i]);
        printf("knn%d_kq_s %.1f\n", bench_k[i], rate(work, repetitions, measure_nearest, &sums));
        printf("knn%d_mean_r2 %.7g\n", bench_k[i], sums.r2 / (double)work->query_count);
    }
    work->query_count = arguments->queries;
    printf("radius_kq_s %.1f\n", rate(work, repetitions, measure_within, &sums));
    printf("radius_mean_found %.4f\nradius_power %.7g\n", sums.found / queries, sums.power / queries);
}

int main(int argc, char **argv)
{
    BenchArguments arguments = bench_arguments(argc, argv);
    omp_set_num_threads(arguments.threads);
    StoredPhoton *photons = make_photons(arguments.photons);
    BenchQuery *queries = bench_allocate(arguments.queries, sizeof *queries);
    bench_fill_queries(queries, arguments.queries);
    double build;
    PhotonMap *map = time_build(photons, arguments.photons, arguments.repetitions, &build);
    printf("build_mpoints_s %.2f\n", build);
    printf("bytes_per_photon %.2f\n", (double)photon_map_bytes(map) / (double)arguments.photons);
    Work work = {map, queries, arguments.queries, 0, bench_radius(arguments.photons)};
    print_measures(&work, &arguments);
    photon_map_free(map);
    free(photons);
    free(queries);
    return 0;
}
