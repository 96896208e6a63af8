// How many rays a second the hierarchy answers, one at a time, and Embree 4: both in turn, in short batches, so that whatever else
// the machine does meets both alike. usage: rays box|mesh THREADS [RAYS]
#include "rays_common.h"
#include "scene/bvh/bvh.h"

#include <omp.h>

#define BATCH   10000 // rays
#define BATCHES 1000  // at most

// What of Embree's interface is needed here: its library comes without headers.
typedef struct {
    float origin[3], t_min, direction[3], time, t_max;
    unsigned mask, id, flags;
} __attribute__((aligned(16))) EmbreeRay;
typedef struct {
    EmbreeRay ray;
    float normal[3], u, v;
    unsigned primitive, geometry, instance[5]; // and what else a build of it may write
} __attribute__((aligned(16))) EmbreeHit;
enum { TRIANGLES = 0, MEDIUM_QUALITY = 1, INDEX_BUFFER = 0, VERTEX_BUFFER = 1, UINT3 = 0x5003, FLOAT3 = 0x9003 };
void *rtcNewDevice(const char *configuration), *rtcNewScene(void *device), *rtcNewGeometry(void *device, int type);
void rtcSetSceneBuildQuality(void *scene, int quality);
void *rtcSetNewGeometryBuffer(void *geometry, int type, unsigned slot, int format, size_t stride, size_t count);
void rtcCommitGeometry(void *geometry), rtcReleaseGeometry(void *geometry), rtcCommitScene(void *scene);
unsigned rtcAttachGeometry(void *scene, void *geometry);
void rtcIntersect1(void *scene, EmbreeHit *hit, void *arguments),
    rtcOccluded1(void *scene, EmbreeRay *ray, void *arguments);

static Bvh *bvh;
static void *embree;

static Vec3 vertex(const BenchMesh *mesh, size_t corner)
{
    const float *v = &mesh->vertices[3 * mesh->triangles[corner]];
    return vec3(v[0], v[1], v[2]);
}

// Embree, too, is timed with the copy of vertices into its own buffers.
static void build(const BenchMesh *mesh)
{
    Flat *flats = bench_allocate(mesh->triangle_count, sizeof *flats);
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        Vec3 a = vertex(mesh, 3 * i);
        Vec3 edge_u = vec3_sub(vertex(mesh, 3 * i + 1), a), edge_v = vec3_sub(vertex(mesh, 3 * i + 2), a);
        flats[i] = (Flat){.origin = a, .edge_u = edge_u, .edge_v = edge_v, .is_triangle = 1};
    }
    Error error = {""};
    bvh = bvh_build(flats, mesh->triangle_count, NULL, 0, &error);
    free(flats);
    if (!bvh) {
        fprintf(stderr, "rays: %s\n", error.message);
        exit(1);
    }
}

static void embree_build(const BenchMesh *mesh, int threads)
{
    char configuration[32];
    snprintf(configuration, sizeof configuration, "threads=%d", threads);
    void *device = rtcNewDevice(configuration), *geometry = rtcNewGeometry(device, TRIANGLES);
    const size_t stride = 3 * sizeof(float);
    void *vertices = rtcSetNewGeometryBuffer(geometry, VERTEX_BUFFER, 0, FLOAT3, stride, mesh->vertex_count);
    void *triangles = rtcSetNewGeometryBuffer(geometry, INDEX_BUFFER, 0, UINT3, stride, mesh->triangle_count);
    memcpy(vertices, mesh->vertices, mesh->vertex_count * stride);
    memcpy(triangles, mesh->triangles, mesh->triangle_count * stride);
    embree = rtcNewScene(device);
    rtcSetSceneBuildQuality(embree, MEDIUM_QUALITY);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(embree, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(embree);
}

static bool meets(const BenchRay *r, bool any)
{
    Ray ray = {vec3(r->origin[0], r->origin[1], r->origin[2]), vec3(r->direction[0], r->direction[1], r->direction[2]),
               NO_PRIMITIVE};
    BvhHit hit;
    return any ? bvh_occluded(bvh, &ray, BENCH_T_MIN, r->t_max, NO_PRIMITIVE)
               : bvh_closest(bvh, &ray, BENCH_T_MIN, r->t_max, &hit);
}

static bool embree_meets(const BenchRay *r, bool any)
{
    EmbreeHit hit = {.ray = {.t_min = BENCH_T_MIN, .t_max = r->t_max, .mask = UINT32_MAX}, .geometry = UINT32_MAX};
    memcpy(hit.ray.origin, r->origin, sizeof r->origin);
    memcpy(hit.ray.direction, r->direction, sizeof r->direction);
    hit.instance[0] = UINT32_MAX;
    if (any)
        rtcOccluded1(embree, &hit.ray, NULL);
    else
        rtcIntersect1(embree, &hit, NULL);
    return any ? hit.ray.t_max < 0.0f : hit.geometry != UINT32_MAX;
}

// Seconds for a batch by one engine.
static double send(const BenchRay *rays, bool any, bool by_embree, int threads, long *hits)
{
    long met = 0;
    double start = bench_seconds();
#pragma omp parallel for schedule(static) num_threads(threads) reduction(+ : met)
    for (size_t i = 0; i < BATCH; i++)
        met += by_embree ? embree_meets(&rays[i], any) : meets(&rays[i], any);
    *hits += met;
    return bench_seconds() - start;
}

// Medians over the batches: million rays a second of each, and the ratio.
static void compare(const char *name, BenchRay *rays, size_t count, bool any, int threads)
{
    static double rate[2][BATCHES], ratio[BATCHES];
    long hits[2] = {0, 0};
    int batches = (int)(count / BATCH);
    for (int i = 0; i < batches; i++) {
        for (int turn = 0; turn < 2; turn++) {
            int engine = (turn + i) % 2;
            rate[engine][i] = 1e-6 * BATCH / send(rays + (size_t)i * BATCH, any, engine, threads, &hits[engine]);
        }
        ratio[i] = rate[0][i] / rate[1][i];
    }
    printf("%s %.3f %.3f %.3f %ld %ld\n", name, bench_median(rate[0], batches), bench_median(rate[1], batches),
           bench_median(ratio, batches), hits[0], hits[1]);
    free(rays);
}

int main(int argc, char **argv)
{
    bool box = argc > 1 && strcmp(argv[1], "box") == 0;
    if (argc < 3 || (!box && strcmp(argv[1], "mesh") != 0)) {
        fprintf(stderr, "usage: %s box|mesh THREADS [RAYS]\n", argv[0]);
        return 1;
    }
    int threads = (int)bench_number(argc, argv, 2, 1, 1024);
    size_t count = (size_t)bench_number(argc, argv, 3, 1000000, (long)BATCHES * BATCH);
    BenchMesh mesh = mesh_create(box);
    omp_set_num_threads(threads);
    double start = bench_seconds();
    build(&mesh);
    double middle = bench_seconds();
    embree_build(&mesh, threads);
    double end = bench_seconds();
    printf("build %.3f %.3f %.3f\n", middle - start, end - middle, (end - middle) / (middle - start));
    compare("closest", rays_incoherent(box, false, count), count, false, threads);
    compare("any", rays_incoherent(box, true, count), count, true, threads);
    BenchRay *camera = rays_camera(&count);
    compare("camera", camera, count, false, threads);
    return 0;
}
