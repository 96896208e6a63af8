// How many rays a second the hierarchy answers, and how long it takes to build. rays_embree.c does the same
// with Embree. usage: rays box|mesh THREADS [RAYS] [REPEATS], or: rays tiny   (six parallelograms and two
// spheres, one thread)
#include "rays_common.h"
#include "scene/bvh/bvh.h"

#include <omp.h>

static Bvh *engine_bvh;

static void build(const Flat *flats, size_t flat_count, const Sphere *spheres, size_t sphere_count)
{
    Error error = {""};
    engine_bvh = bvh_build(flats, flat_count, spheres, sphere_count, &error);
    if (!engine_bvh) {
        fprintf(stderr, "rays: %s\n", error.message);
        exit(1);
    }
}

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
    build(flats, mesh->triangle_count, NULL, 0);
    free(flats);
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

// As photons see a first scene: a closed box with two spheres.
static void bench_tiny(void)
{
    const Flat walls[6] = {
        {.origin = {-1, -1, -1}, .edge_u = {2, 0, 0}, .edge_v = {0, 2, 0}},
        {.origin = {-1, -1, 1}, .edge_u = {2, 0, 0}, .edge_v = {0, 2, 0}},
        {.origin = {-1, -1, -1}, .edge_u = {0, 2, 0}, .edge_v = {0, 0, 2}},
        {.origin = {1, -1, -1}, .edge_u = {0, 2, 0}, .edge_v = {0, 0, 2}},
        {.origin = {-1, -1, -1}, .edge_u = {0, 0, 2}, .edge_v = {2, 0, 0}},
        {.origin = {-1, 1, -1}, .edge_u = {0, 0, 2}, .edge_v = {2, 0, 0}},
    };
    const Sphere spheres[2] = {{.centre = {-0.42f, -0.65f, -0.30f}, .radius = 0.35f},
                               {.centre = {0.40f, -0.65f, 0.25f}, .radius = 0.35f}};
    build(walls, 6, spheres, 2);
    BenchRay *rays = rays_incoherent(true, false, 1000000);
    printf("scene tiny\nthreads 1\n");
    run_rays("closest", rays, 1000000, false, 1, 5);
    run_rays("any", rays, 1000000, true, 1, 5);
    free(rays);
    engine_free();
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "tiny") == 0) {
        bench_tiny();
        return 0;
    }
    return bench_main(argc, argv);
}
