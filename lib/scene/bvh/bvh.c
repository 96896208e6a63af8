// Bounding volume hierarchy: from shapes to boxes, and from the finished tree to packets.
#include "scene/bvh/bvh.h"

#include "scene/bvh/bvh_internal.h"

#include <stdlib.h>

// A box reaches this much farther than its shape, relative to its coordinates, so that rounding does not put a hit
// on the shape outside the box.
#define BOX_PADDING 2e-6f

static Reference reference_create(Box box, size_t id)
{
    Reference r = {{box.low.x, box.low.y, box.low.z, 0.0f}, {box.high.x, box.high.y, box.high.z, 0.0f}};
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

static Box flat_box(const void *flats, size_t i)
{
    const Flat *flat = (const Flat *)flats + i;
    Box box = box_empty();
    Vec3 u = vec3_add(flat->origin, flat->edge_u);
    box_add_point(&box, flat->origin);
    box_add_point(&box, u);
    box_add_point(&box, vec3_add(flat->origin, flat->edge_v));
    if (!flat->is_triangle)
        box_add_point(&box, vec3_add(u, flat->edge_v));
    return box;
}

static Box sphere_box(const void *spheres, size_t i)
{
    const Sphere *sphere = (const Sphere *)spheres + i;
    Vec3 radius = vec3(sphere->radius, sphere->radius, sphere->radius);
    return (Box){vec3_sub(sphere->centre, radius), vec3_add(sphere->centre, radius)};
}

static void pack_flats(const Shapes *shapes, const Reference *references, uint32_t count, void *packet)
{
    FlatPacket *to = packet;
    *to = (FlatPacket){.id = {TRIANGLE - 1, TRIANGLE - 1, TRIANGLE - 1, TRIANGLE - 1}};
    for (uint32_t lane = 0; lane < count; lane++) {
        uint32_t id = reference_id(&references[lane]);
        const Flat *flat = (const Flat *)shapes->items + id;
        for (int axis = 0; axis < 3; axis++) {
            to->origin[axis][lane] = vec3_component(flat->origin, axis);
            to->edge_u[axis][lane] = vec3_component(flat->edge_u, axis);
            to->edge_v[axis][lane] = vec3_component(flat->edge_v, axis);
        }
        to->id[lane] = flat->is_triangle ? id | TRIANGLE : id;
    }
}

static void pack_spheres(const Shapes *shapes, const Reference *references, uint32_t count, void *packet)
{
    SpherePacket *to = packet;
    *to = (SpherePacket){.radius2 = {-1.0f, -1.0f, -1.0f, -1.0f}, .id = {TRIANGLE, TRIANGLE, TRIANGLE, TRIANGLE}};
    for (uint32_t lane = 0; lane < count; lane++) {
        uint32_t index = reference_id(&references[lane]);
        const Sphere *sphere = (const Sphere *)shapes->items + index;
        for (int axis = 0; axis < 3; axis++)
            to->centre[axis][lane] = vec3_component(sphere->centre, axis);
        to->radius2[lane] = sphere->radius * sphere->radius;
        to->id[lane] = (uint32_t)shapes->first_id + index;
    }
}

// The tree over the shapes, whose memory the caller owns. False when memory is short.
static bool build_tree(const Shapes *shapes, Tree *tree)
{
    *tree = (Tree){.root = NO_CHILD, .packet_places = (uint32_t)(shapes->packet_size / PLACE)};
    Reference *references = array_allocate(shapes->count * sizeof *references);
    if (!references)
        return false;
    OMP(omp parallel for schedule(static) if (shapes->count > TASK_COUNT))
    for (size_t i = 0; i < shapes->count; i++)
        references[i] = reference_create(shapes->box(shapes->items, i), i);
    bool done = bvh_build_tree(shapes, references, tree);
    free(references);
    return done;
}

static void add_bounds(Box *box, const Shapes *shapes)
{
    for (size_t i = 0; i < shapes->count; i++) {
        Box one = shapes->box(shapes->items, i);
        box_add_point(box, one.low);
        box_add_point(box, one.high);
    }
}

Bvh *bvh_build(const Flat *flats, size_t flat_count, const Sphere *spheres, size_t sphere_count, Error *error)
{
    const Shapes all_flats = {flats, flat_count, 0, flat_box, pack_flats, sizeof(FlatPacket)};
    const Shapes all_spheres = {spheres, sphere_count, flat_count, sphere_box, pack_spheres, sizeof(SpherePacket)};
    Bvh *bvh = calloc(1, sizeof *bvh);
    if (bvh && build_tree(&all_flats, &bvh->flats) && build_tree(&all_spheres, &bvh->spheres)) {
        bvh->bounds = box_empty();
        add_bounds(&bvh->bounds, &all_flats);
        add_bounds(&bvh->bounds, &all_spheres);
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
    free(bvh->flats.memory);
    free(bvh->spheres.memory);
    free(bvh);
}

Box bvh_bounds(const Bvh *bvh)
{
    return bvh->bounds;
}
