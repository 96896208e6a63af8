// The same rays through Embree 3, one at a time: the yardstick for rays.c, with the same output.
// usage: rays_embree box|mesh THREADS [RAYS] [REPEATS]
#include "rays_common.h"

#include <embree3/rtcore.h>

static RTCDevice engine_device;
static RTCScene engine_scene;

static void engine_build(const BenchMesh *mesh, int threads)
{
    if (!engine_device) {
        char configuration[32];
        snprintf(configuration, sizeof configuration, "threads=%d", threads);
        engine_device = rtcNewDevice(configuration);
    }
    engine_scene = rtcNewScene(engine_device);
    rtcSetSceneBuildQuality(engine_scene, RTC_BUILD_QUALITY_MEDIUM);
    RTCGeometry geometry = rtcNewGeometry(engine_device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const size_t stride = 3 * sizeof(float);
    void *vertices =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, stride, mesh->vertex_count);
    void *triangles =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, stride, mesh->triangle_count);
    if (!vertices || !triangles) {
        fprintf(stderr, "rays_embree: not enough memory\n");
        exit(1);
    }
    memcpy(vertices, mesh->vertices, mesh->vertex_count * stride);
    memcpy(triangles, mesh->triangles, mesh->triangle_count * stride);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(engine_scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(engine_scene);
}

static void engine_free(void)
{
    rtcReleaseScene(engine_scene);
}

static struct RTCRay to_ray(const BenchRay *r)
{
    return (struct RTCRay){.org_x = r->origin[0],
                           .org_y = r->origin[1],
                           .org_z = r->origin[2],
                           .dir_x = r->direction[0],
                           .dir_y = r->direction[1],
                           .dir_z = r->direction[2],
                           .tnear = BENCH_T_MIN,
                           .tfar = r->t_max,
                           .mask = UINT32_MAX};
}

static float engine_closest(const BenchRay *bench_ray)
{
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    struct RTCRayHit query = {.ray = to_ray(bench_ray)};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(engine_scene, &context, &query);
    return query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? -1.0f : query.ray.tfar;
}

static bool engine_occluded(const BenchRay *bench_ray)
{
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    struct RTCRay query = to_ray(bench_ray);
    rtcOccluded1(engine_scene, &context, &query);
    return query.tfar < 0.0f;
}
