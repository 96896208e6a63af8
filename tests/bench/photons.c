// The photon pass and the photon map on this machine, in numbers.
#include "base/array.h"
#include "cli/cli.h"

#include <stdio.h>

static const char help[] =
    "usage: bench_photons [SCENE] [flags]\n"
    "\n"
    "Measures this machine on a scene (scenes/box_glass.yaml): photon paths a second on one thread and on all; and, by growing\n"
    "numbers of photons, seconds of the photon pass and of building the map, look-ups a second (50 nearest photons), bytes a\n"
    "stored photon. Each figure is the best of three runs.\n"
    "\n"
    "  --photons N    for the photon pass (1000000)\n"
    "  --most N       last row of the table: 10000, 100000, … up to N (1000000)\n"
    "  --threads T    0: all cores\n";

typedef struct {
    const char *scene;
    long photons, most;
    int threads;
} Arguments;

#define QUERIES 100000
#define NEAREST 50

static bool run_pass(const Scene *scene, long photons, int threads, unsigned keep, PhotonPass *pass, Error *error)
{
    PhotonPassOptions options = {
        .photons = photons, .depth = scene->settings.depth, .seed = 1, .threads = threads, .keep = keep};
    return photon_pass_run(scene, &options, pass, error);
}

// The fastest of three passes that store every photon.
static bool best_pass(const Scene *scene, long photons, int threads, PhotonPass *best, Error *error)
{
    for (int run = 0; run < 3; run++) {
        PhotonPass pass;
        if (!run_pass(scene, photons, threads, KEEP_ALL, &pass, error))
            return false;
        photon_pass_free(&pass);
        if (run == 0 || pass.seconds < best->seconds)
            *best = pass;
    }
    return true;
}

// Look-ups a second on all threads, at the places of every so-many-th photon in the map's own order.
static double look_ups_per_second(const PhotonMap *map)
{
    const StoredPhoton *photons = photon_map_photons(map);
    size_t count = photon_map_count(map);
    double best = 0.0;
    for (int run = 0; run < 3; run++) {
        double start = clock_seconds();
#pragma omp parallel for schedule(dynamic, 1000)
        for (long i = 0; i < QUERIES; i++) {
            NearPhoton near[PHOTON_MAP_NEAREST_CAPACITY(NEAREST)];
            float radius2 = INFINITY;
            photon_map_nearest(map, photons[(size_t)i * count / QUERIES].position, NEAREST, &radius2, near);
        }
        double rate = QUERIES / (clock_seconds() - start);
        best = rate > best ? rate : best;
    }
    return best;
}

static bool print_row(const Scene *scene, long photons, int threads, Error *error)
{
    PhotonPass best;
    PhotonPass pass;
    if (!best_pass(scene, photons, threads, &best, error) || !run_pass(scene, photons, threads, KEEP_ALL, &pass, error))
        return false;
    double start = clock_seconds();
    PhotonMap *map = photon_map_build(pass.rest.photons, pass.rest.count, error);
    double build = clock_seconds() - start;
    pass.rest.photons = NULL;
    photon_pass_free(&pass);
    if (!map)
        return false;
    double count = (double)photon_map_count(map);
    printf("%10ld %10.0f %9.4f %9.4f %12.0f %9.2f\n", photons, count, best.seconds, build,
           count > 0.0 ? look_ups_per_second(map) : 0.0, count > 0.0 ? (double)photon_map_bytes(map) / count : 0.0);
    photon_map_free(map);
    return true;
}

static bool print_tables(const Scene *scene, const Arguments *a, Error *error)
{
    PhotonPass one = {.seconds = INFINITY};
    PhotonPass all = {.seconds = INFINITY};
    int threads = parallel_threads(a->threads);
    for (int round = 0; round < 3; round++) { // in turn, since machines speed up and slow down
        PhotonPass now_one, now_all;
        if (!best_pass(scene, a->photons, 1, &now_one, error) ||
            !best_pass(scene, a->photons, threads, &now_all, error))
            return false;
        one = now_one.seconds < one.seconds ? now_one : one;
        all = now_all.seconds < all.seconds ? now_all : all;
    }
    double n = (double)a->photons;
    printf("%s: %ld photons, %.2f segments and %.2f stored photons a path\n", a->scene, a->photons,
           (double)one.segments / n, (double)one.stored / n);
    printf("  1 thread   %.2f M paths/s   %.2f M segments/s\n", n / one.seconds / 1e6,
           (double)one.segments / one.seconds / 1e6);
    printf("  %d threads  %.2f M paths/s   %.2f M segments/s   %.2f times one\n\n", threads, n / all.seconds / 1e6,
           (double)all.segments / all.seconds / 1e6, one.seconds / all.seconds);
    printf("   photons     stored    pass s   build s    look-ups/s  bytes each\n");
    for (long photons = 10000; photons <= a->most; photons *= 10)
        if (!print_row(scene, photons, threads, error))
            return false;
    return true;
}

// 0 when the arguments are right, otherwise the exit code or HELP_SHOWN.
static int parse(int count, char **arguments, Arguments *a)
{
    *a = (Arguments){"scenes/box_glass.yaml", 1000000, 1000000, 0};
    const Flag flags[] = {
        {"photons", FLAG_LONG, &a->photons, 1, MOST_PHOTONS},
        {"most", FLAG_LONG, &a->most, 1, MOST_PHOTONS},
        {"threads", FLAG_INT, &a->threads, 0, MOST_THREADS},
    };
    return command_line_parse(
        &(CommandLine){"bench_photons", help, "one scene file at most", flags, FLAG_COUNT(flags), 0, 1}, count,
        arguments, &a->scene);
}

int main(int count, char **arguments)
{
    array_keep_memory(); // as `photonlab render` does
    Arguments a;
    int wrong = parse(count, arguments, &a);
    if (wrong)
        return wrong == HELP_SHOWN ? 0 : wrong;
    Error error = {""};
    Scene *scene = NULL;
    if (!steps_load(NULL, &error) || !(scene = scene_load(a.scene, &error)))
        return report_error(&error);
    parallel_limit(a.threads);
    bool ok = print_tables(scene, &a, &error);
    scene_free(scene);
    return ok ? 0 : report_error(&error);
}
