// Bounding volume hierarchy: from shapes to boxes, and from the finished tree to packets.
#include "scene/bvh/bvh.h"

#include "scene/bvh/bvh_internal.h"

#include <stdlib.h>
#include <sys/mman.h>

// A box reaches this much farther than its shape, relative to its coordinates, so that rounding does not put a hit
// on the shape outside the box.
#define BOX_PADDING 2e-6f
#define LARGE_PAGE  ((size_t)2 << 20)

void *bvh_allocate(size_t bytes)
{
    void *memory = NULL;
    size_t alignment = bytes < LARGE_PAGE ? 64 : LARGE_PAGE;
    if (posix_memalign(&memory, alignment, bytes + (bytes == 0)))
        return NULL;
#ifdef MADV_HUGEPAGE
    if (bytes >= LARGE_PAGE)
        madvise(memory, bytes, MADV_HUGEPAGE); // a wish; that it fails is no error
#endif
    return memory;
}

static Reference reference_create(Vec3 low, Vec3 high, size_t id)
{
    Reference r = {{low.x, low.y, low.z, 0.0f}, {high.x, high.y, high.z, 0.0f}};
    for (int axis = 0; axis < 3; axis++) {
        float reach = fmaxf(fabsf(r.low[axis]), fabsf(r.high[axis]));
        float pad = BOX_PADDING * reach + EDGE_SLACK * (r.high[axis] - r.low[axis]);
        r.low[axis] -= pad;
        r.high[axis] += pad;
    }
    r.low[3] = (float)(id & 0xffffu);
    r.high[3] = (float)(id >> 16);
    return r;
}

static Reference flat_reference(const Flat *flat, size_t id)
{
    Box box = box_empty();
    Vec3 u = vec3_add(flat->origin, flat->edge_u);
    box_add_point(&box, flat->origin);
    box_add_point(&box, u);
    box_add_point(&box, vec3_add(flat->origin, flat->edge_v));
    if (!flat->is_triangle)
        box_add_point(&box, vec3_add(u, flat->edge_v));
    return reference_create(box.low, box.high, id);
}

static Reference sphere_reference(const Sphere *sphere, size_t id)
{
    Vec3 radius = vec3(sphere->radius, sphere->radius, sphere->radius);
    return reference_create(vec3_sub(sphere->centre, radius), vec3_add(sphere->centre, radius), id);
}

static FlatPacket flat_packet(const Flat *flats, const Reference *references, Run run)
{
    FlatPacket packet = {.id = {TRIANGLE - 1, TRIANGLE - 1, TRIANGLE - 1, TRIANGLE - 1}};
    for (uint32_t lane = 0; lane < run.count; lane++) {
        uint32_t id = reference_id(&references[run.first + lane]);
        const Flat *flat = &flats[id];
        for (int axis = 0; axis < 3; axis++) {
            packet.origin[axis][lane] = vec3_component(flat->origin, axis);
            packet.edge_u[axis][lane] = vec3_component(flat->edge_u, axis);
            packet.edge_v[axis][lane] = vec3_component(flat->edge_v, axis);
        }
        packet.id[lane] = flat->is_triangle ? id | TRIANGLE : id;
    }
    return packet;
}

// The spheres' numbers begin at first_id.
static SpherePacket sphere_packet(const Sphere *spheres, size_t first_id, const Reference *references, Run run)
{
    SpherePacket packet = {.radius2 = {-1.0f, -1.0f, -1.0f, -1.0f}, .id = {TRIANGLE, TRIANGLE, TRIANGLE, TRIANGLE}};
    for (uint32_t lane = 0; lane < run.count; lane++) {
        uint32_t index = reference_id(&references[run.first + lane]);
        for (int axis = 0; axis < 3; axis++)
            packet.centre[axis][lane] = vec3_component(spheres[index].centre, axis);
        packet.radius2[lane] = spheres[index].radius * spheres[index].radius;
        packet.id[lane] = (uint32_t)first_id + index;
    }
    return packet;
}

static bool build_flats(Bvh *bvh, const Flat *flats, size_t count)
{
    Reference *references = bvh_allocate(count * sizeof *references);
    Run *runs = NULL;
    if (references) {
        OMP(omp parallel for schedule(static) if (count > TASK_COUNT))
        for (size_t i = 0; i < count; i++)
            references[i] = flat_reference(&flats[i], i);
    }
    bool done = references && bvh_build_tree(references, count, &bvh->flats, &runs);
    if (done)
        bvh->flat_packets = bvh_allocate(bvh->flats.packet_count * sizeof *bvh->flat_packets);
    done = done && bvh->flat_packets;
    if (done) {
        bvh->flats.packets = (const char *)bvh->flat_packets;
        bvh->flats.packet_size = sizeof *bvh->flat_packets;
        OMP(omp parallel for schedule(static) if (count > TASK_COUNT))
        for (uint32_t i = 0; i < bvh->flats.packet_count; i++)
            bvh->flat_packets[i] = flat_packet(flats, references, runs[i]);
    }
    free(runs);
    free(references);
    return done;
}

static bool build_spheres(Bvh *bvh, const Sphere *spheres, size_t count, size_t first_id)
{
    Reference *references = bvh_allocate(count * sizeof *references);
    Run *runs = NULL;
    for (size_t i = 0; references && i < count; i++)
        references[i] = sphere_reference(&spheres[i], i);
    bool done = references && bvh_build_tree(references, count, &bvh->spheres, &runs);
    if (done)
        bvh->sphere_packets = bvh_allocate(bvh->spheres.packet_count * sizeof *bvh->sphere_packets);
    done = done && bvh->sphere_packets;
    if (done) {
        bvh->spheres.packets = (const char *)bvh->sphere_packets;
        bvh->spheres.packet_size = sizeof *bvh->sphere_packets;
        for (uint32_t i = 0; i < bvh->spheres.packet_count; i++)
            bvh->sphere_packets[i] = sphere_packet(spheres, first_id, references, runs[i]);
    }
    free(runs);
    free(references);
    return done;
}

static Box shapes_bounds(const Flat *flats, size_t flat_count, const Sphere *spheres, size_t sphere_count)
{
    Box box = box_empty();
    for (size_t i = 0; i < flat_count; i++) {
        Vec3 u = vec3_add(flats[i].origin, flats[i].edge_u);
        box_add_point(&box, flats[i].origin);
        box_add_point(&box, u);
        box_add_point(&box, vec3_add(flats[i].origin, flats[i].edge_v));
        if (!flats[i].is_triangle)
            box_add_point(&box, vec3_add(u, flats[i].edge_v));
    }
    for (size_t i = 0; i < sphere_count; i++) {
        Vec3 radius = vec3(spheres[i].radius, spheres[i].radius, spheres[i].radius);
        box_add_point(&box, vec3_sub(spheres[i].centre, radius));
        box_add_point(&box, vec3_add(spheres[i].centre, radius));
    }
    return box;
}

Bvh *bvh_build(const Flat *flats, size_t flat_count, const Sphere *spheres, size_t sphere_count, Error *error)
{
    Bvh *bvh = calloc(1, sizeof *bvh);
    if (bvh && build_flats(bvh, flats, flat_count) && build_spheres(bvh, spheres, sphere_count, flat_count)) {
        bvh->bounds = shapes_bounds(flats, flat_count, spheres, sphere_count);
        return bvh;
    }
    bvh_free(bvh);
    error_set(error, "not enough memory for the hierarchy over %zu surfaces", flat_count + sphere_count);
    return NULL;
}

void bvh_free(Bvh *bvh)
{
    if (!bvh)
        return;
    free(bvh->flats.nodes);
    free(bvh->spheres.nodes);
    free(bvh->flat_packets);
    free(bvh->sphere_packets);
    free(bvh);
}

size_t bvh_bytes(const Bvh *bvh)
{
    return sizeof *bvh + ((size_t)bvh->flats.node_count + bvh->spheres.node_count) * sizeof(Node) +
           bvh->flats.packet_count * sizeof(FlatPacket) + bvh->spheres.packet_count * sizeof(SpherePacket);
}

Box bvh_bounds(const Bvh *bvh)
{
    return bvh->bounds;
}
