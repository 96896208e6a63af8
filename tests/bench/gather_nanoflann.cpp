// The same work as gather.c, done with nanoflann (Blanco and Rai 2014), a kd-tree that users would otherwise
// take. Each figure is the better of leaves of 10 (nanoflann's own choice) and of 32 points.
//   gather_nanoflann PHOTONS THREADS [QUERIES] [REPETITIONS]
#include "gather_common.h"

#include <nanoflann.hpp>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace
{

// Points apart from what is carried with them: what suits this tree best when only positions are asked for.
struct Points {
    std::vector<float> xyz;

    size_t kdtree_get_point_count() const
    {
        return xyz.size() / 3;
    }
    float kdtree_get_pt(size_t index, size_t axis) const
    {
        return xyz[3 * index + axis];
    }
    template <class Bounds> bool kdtree_get_bbox(Bounds &) const
    {
        return false;
    }
};

using Distance = nanoflann::L2_Simple_Adaptor<float, Points>;
using Tree = nanoflann::KDTreeSingleIndexAdaptor<Distance, Points, 3, uint32_t>;
#if NANOFLANN_VERSION >= 0x150
using Found = nanoflann::ResultItem<uint32_t, float>;
using Parameters = nanoflann::SearchParameters;
#else // 1.4 and before: builds with one thread, whatever is asked for
using Found = std::pair<uint32_t, float>;
using Parameters = nanoflann::SearchParams;
#endif

std::unique_ptr<Tree> build_tree(const Points &points, size_t leaf, int threads)
{
    nanoflann::KDTreeSingleIndexAdaptorParams parameters(leaf);
#if NANOFLANN_VERSION >= 0x150
    parameters.n_thread_build = static_cast<unsigned>(threads);
#else
    (void)threads;
#endif
    return std::unique_ptr<Tree>(new Tree(3, points, parameters));
}

struct Sums {
    double r2 = 0.0, found = 0.0, power = 0.0;
};

struct Scratch {
    std::vector<uint32_t> indices = std::vector<uint32_t>(BENCH_MAX_K);
    std::vector<float> distances = std::vector<float>(BENCH_MAX_K);
    std::vector<Found> found;
};

Sums nearest(const Tree &tree, const BenchQuery &query, size_t k, Scratch &scratch)
{
    Sums sums;
    size_t found = tree.knnSearch(query.position, k, scratch.indices.data(), scratch.distances.data());
    sums.r2 = scratch.distances[k - 1];
    sums.found = static_cast<double>(found);
    return sums;
}

Sums within(const Tree &tree, const std::vector<BenchPhoton> &photons, const BenchQuery &query, float radius,
            Scratch &scratch)
{
    Parameters parameters;
    parameters.sorted = false;
    scratch.found.clear();
    Sums sums;
    sums.found = static_cast<double>(tree.radiusSearch(query.position, radius * radius, scratch.found, parameters));
    float power[3] = {0.0f, 0.0f, 0.0f};
    float per_radius = 1.0f / radius;
    for (const Found &item : scratch.found) {
        const BenchPhoton &photon = photons[item.first];
        const float *n = query.normal;
        if (photon.wi[0] * n[0] + photon.wi[1] * n[1] + photon.wi[2] * n[2] <= 0.0f)
            continue;
        float weight = 1.0f - std::sqrt(item.second) * per_radius;
        for (int axis = 0; axis < 3; axis++)
            power[axis] += weight * photon.power[axis];
    }
    sums.power = power[0] + power[1] + power[2];
    return sums;
}

double median_seconds(std::vector<double> &seconds)
{
    return bench_median(seconds.data(), static_cast<int>(seconds.size()));
}

// Thousand queries a second, the median of all repetitions.
template <class Query>
double rate(const std::vector<BenchQuery> &queries, size_t count, int repetitions, Sums &sums, Query ask)
{
    std::vector<double> seconds;
    for (int repetition = 0; repetition < repetitions; repetition++) {
        double r2 = 0.0, found = 0.0, power = 0.0;
        double start = bench_seconds();
#pragma omp parallel reduction(+ : r2, found, power)
        {
            Scratch scratch;
#pragma omp for schedule(static)
            for (size_t i = 0; i < count; i++) {
                Sums one = ask(queries[i], scratch);
                r2 += one.r2;
                found += one.found;
                power += one.power;
            }
        }
        seconds.push_back(bench_seconds() - start);
        sums.r2 = r2;
        sums.found = found;
        sums.power = power;
    }
    return 1e-3 * static_cast<double>(count) / median_seconds(seconds);
}

std::unique_ptr<Tree> time_build(const Points &points, size_t leaf, const BenchArguments &arguments, double &best)
{
    std::unique_ptr<Tree> tree;
    std::vector<double> seconds;
    for (int repetition = 0; repetition < arguments.repetitions; repetition++) {
        tree.reset();
        double start = bench_seconds();
        tree = build_tree(points, leaf, arguments.threads);
        seconds.push_back(bench_seconds() - start);
    }
    best = std::max(best, 1e-6 * static_cast<double>(arguments.photons) / median_seconds(seconds));
    return tree;
}

} // namespace

int main(int argc, char **argv)
{
    BenchArguments arguments = bench_arguments(argc, argv);
    if (arguments.photons < BENCH_MAX_K) {
        std::fprintf(stderr, "%s: expected at least %d photons\n", argv[0], static_cast<int>(BENCH_MAX_K));
        return 1;
    }
#ifdef _OPENMP
    omp_set_num_threads(arguments.threads);
#endif
    std::vector<BenchPhoton> photons(arguments.photons);
    bench_fill_photons(photons.data(), arguments.photons);
    std::vector<BenchQuery> queries(arguments.queries);
    bench_fill_queries(queries.data(), arguments.queries);
    Points points;
    for (const BenchPhoton &photon : photons)
        points.xyz.insert(points.xyz.end(), photon.position, photon.position + 3);

    double build = 0.0, bytes = 0.0, best[BENCH_K_COUNT] = {0.0}, best_radius = 0.0;
    Sums sums[BENCH_K_COUNT], radius_sums;
    float radius = bench_radius(arguments.photons);
    for (size_t leaf : {10, 32}) {
        std::unique_ptr<Tree> tree = time_build(points, leaf, arguments, build);
        bytes = static_cast<double>(tree->usedMemory(*tree)) / static_cast<double>(arguments.photons);
        for (int i = 0; i < BENCH_K_COUNT; i++) {
            size_t k = static_cast<size_t>(bench_k[i]);
            auto ask = [&](const BenchQuery &query, Scratch &scratch) { return nearest(*tree, query, k, scratch); };
            best[i] = std::max(
                best[i], rate(queries, bench_queries(&arguments, bench_k[i]), arguments.repetitions, sums[i], ask));
        }
        auto ask = [&](const BenchQuery &query, Scratch &scratch) {
            return within(*tree, photons, query, radius, scratch);
        };
        best_radius = std::max(best_radius, rate(queries, queries.size(), arguments.repetitions, radius_sums, ask));
    }

    double count = static_cast<double>(arguments.queries);
    std::printf("build_mpoints_s %.2f\nindex_bytes_per_photon %.2f\n", build, bytes);
    for (int i = 0; i < BENCH_K_COUNT; i++)
        std::printf("knn%d_kq_s %.1f\nknn%d_mean_r2 %.7g\n", bench_k[i], best[i], bench_k[i],
                    sums[i].r2 / static_cast<double>(bench_queries(&arguments, bench_k[i])));
    std::printf("radius_kq_s %.1f\nradius_mean_found %.4f\nradius_power %.7g\n", best_radius, radius_sums.found / count,
                radius_sums.power / count);
    return 0;
}
