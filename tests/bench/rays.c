// How many rays a second the hierarchy answers, and how long it takes to build. rays_embree.c does the same
// with Embree. usage: rays box|mesh THREADS [RAYS] [REPEATS]
#include "rays_common.h"
#include "scene/bvh/bvh.h"

#include <omp.h>

static Bvh *engine_bvh;

static Vec3 vertex(const BenchMesh *mesh, size_t corner)
{
    const float *v = &mesh->vertices[3 * mesh->triangles[corner]];
    return vec3(v[0], v[1], v[2]);
}

static void engine_build(const BenchMesh *mesh, int threads)
{
    omp_set_num_threads(threads);
    // Embree, too, is timed with the copy of vertices into its own buffers.
    Flat *flats = bench_allocate(mesh->triangle_count, sizeof *flats);
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        Vec3 a = vertex(mesh, 3 * i);
        flats[i] = (Flat){.origin = a,
                          .edge_u = vec3_sub(vertex(mesh, 3 * i + 1), a),
                          .edge_v = vec3_sub(vertex(mesh, 3 * i + 2), a),
                          .is_triangle = 1};
    }
    Error error = {""};
    engine_bvh = bvh_build(flats, mesh->triangle_count, NULL, 0, &error);
    free(flats);
    if (!engine_bvh) {
        fprintf(stderr, "rays: %s\n", error.message);
        exit(1);
    }
}

static void engine_free(void)
{
    bvh_free(engine_bvh);
    engine_bvh = NULL;
}

static Ray to_ray(const BenchRay *r)
{
    return (Ray){vec3(r->origin[0], r->origin[1], r->origin[2]),
                 vec3(r->direction[0], r->direction[1], r->direction[2]), NO_PRIMITIVE};
}

static float engine_closest(const BenchRay *bench_ray)
{
    Ray ray = to_ray(bench_ray);
    BvhHit hit;
    return bvh_closest(engine_bvh, &ray, BENCH_T_MIN, bench_ray->t_max, &hit) ? hit.t : -1.0f;
}

static bool engine_occluded(const BenchRay *bench_ray)
{
    Ray ray = to_ray(bench_ray);
    return bvh_occluded(engine_bvh, &ray, BENCH_T_MIN, bench_ray->t_max, NO_PRIMITIVE);
}
