#include "scene/file/scene_load.h"

#include "base/array.h"
#include "base/text.h"

#include <string.h>

static bool memory_fault(const SceneLoader *loader)
{
    return error_set(loader->error, "%s: not enough memory for the shapes", loader->file);
}

bool scene_add_flat(SceneLoader *loader, Flat flat)
{
    Scene *scene = loader->scene;
    Flat *flats = array_reserve(scene->flats, scene->flat_count, &loader->flat_capacity, sizeof flat);
    if (!flats)
        return memory_fault(loader);
    scene->flats = flats;
    flats[scene->flat_count++] = flat;
    return true;
}

bool scene_add_sphere(SceneLoader *loader, Sphere sphere)
{
    Scene *scene = loader->scene;
    Sphere *spheres = array_reserve(scene->spheres, scene->sphere_count, &loader->sphere_capacity, sizeof sphere);
    if (!spheres)
        return memory_fault(loader);
    scene->spheres = spheres;
    spheres[scene->sphere_count++] = sphere;
    return true;
}

bool scene_add_normals(SceneLoader *loader, const Vec3 corners[3])
{
    Scene *scene = loader->scene;
    for (int i = 0; i < 3; i++) {
        Vec3 *normals = array_reserve(scene->normals, scene->normal_count, &loader->normal_capacity, sizeof *normals);
        if (!normals)
            return memory_fault(loader);
        scene->normals = normals;
        normals[scene->normal_count++] = corners[i];
    }
    return true;
}

bool scene_check_edges(const SceneLoader *loader, const char *key, Vec3 edge_u, Vec3 edge_v)
{
    return !flat_is_degenerate(edge_u, edge_v) ||
           loader_fault(loader, key,
                        "edge_u (%g, %g, %g) and edge_v (%g, %g, %g) are zero or parallel; expected two sides "
                        "that span an area",
                        edge_u.x, edge_u.y, edge_u.z, edge_v.x, edge_v.y, edge_v.z);
}

static const char *material_name(const void *entries, size_t i)
{
    const SceneEntries *all = entries;
    return i < all->materials_count ? all->materials[i].name : NULL;
}

bool scene_find_material(const SceneLoader *loader, const char *name, uint32_t *material)
{
    const char *known;
    for (size_t i = 0; (known = material_name(loader->entries, i)); i++) {
        if (strcmp(known, name) != 0)
            continue;
        *material = (uint32_t)i;
        return true;
    }
    return false;
}

void scene_suggest_material(const SceneLoader *loader, const char *name, char *message, size_t size)
{
    text_suggest(message, size, name, material_name, loader->entries);
}

static bool build_sphere(SceneLoader *loader, const ShapeEntry *entry, uint32_t material)
{
    return scene_add_sphere(loader, (Sphere){vec3_from_entry(entry->centre), *entry->radius, material});
}

static bool build_rectangle(SceneLoader *loader, const ShapeEntry *entry, uint32_t material)
{
    Flat flat = {.origin = vec3_from_entry(entry->corner), .material = material};
    flat.edge_u = vec3_from_entry(entry->edge_u);
    flat.edge_v = vec3_from_entry(entry->edge_v);
    return scene_check_edges(loader, "edge_v", flat.edge_u, flat.edge_v) && scene_add_flat(loader, flat);
}

Vec3 scene_rotate(Vec3 p, int axis, float degrees)
{
    float c = cosf(degrees * (PI / 180.0f)), s = sinf(degrees * (PI / 180.0f));
    if (axis == 0)
        return vec3(p.x, c * p.y - s * p.z, s * p.y + c * p.z);
    if (axis == 1)
        return vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
    return vec3(c * p.x - s * p.y, s * p.x + c * p.y, p.z);
}

static bool build_box(SceneLoader *loader, const ShapeEntry *entry, uint32_t material)
{
    Vec3 low = vec3_from_entry(entry->low), high = vec3_from_entry(entry->high);
    Vec3 size = vec3_sub(high, low), centre = vec3_scale(vec3_add(low, high), 0.5f);
    for (int i = 0; i < 3; i++)
        if (vec3_component(size, i) < SCENE_SMALLEST_LENGTH)
            return loader_fault(loader, "high", "high is not above low in %c (%g to %g); expected a larger number",
                                "xyz"[i], vec3_component(low, i), vec3_component(high, i));
    float angle = entry->rotate_y ? *entry->rotate_y : 0.0f;
    Vec3 edges[3] = {scene_rotate(vec3(size.x, 0, 0), 1, angle), vec3(0, size.y, 0),
                     scene_rotate(vec3(0, 0, size.z), 1, angle)};
    Vec3 corner = vec3_add(centre, scene_rotate(vec3_sub(low, centre), 1, angle));
    for (int i = 0; i < 3; i++) {
        // The edges are right-handed: edge j × edge k points along edge i, out of the far face and into the
        // near one.
        Vec3 j = edges[(i + 1) % 3], k = edges[(i + 2) % 3];
        Flat near_face = {corner, k, j, material, 0, 0};
        Flat far_face = {vec3_add(corner, edges[i]), j, k, material, 0, 0};
        if (!scene_check_edges(loader, "high", j, k) || !scene_add_flat(loader, near_face) ||
            !scene_add_flat(loader, far_face))
            return false;
    }
    return true;
}

static bool build_prism(SceneLoader *loader, const ShapeEntry *entry, uint32_t material)
{
    Vec3 axis = vec3_from_entry(entry->axis), down = vec3_from_entry(entry->down);
    if (flat_is_degenerate(axis, down))
        return loader_fault(loader, "down",
                            "axis and down are zero or parallel; expected the edge's direction and one away from it");
    axis = vec3_normalize(axis);
    down = vec3_normalize(vec3_sub(down, vec3_scale(axis, vec3_dot(axis, down))));
    Vec3 sideways = vec3_cross(axis, down);
    float half_angle = 0.5f * *entry->angle * (PI / 180.0f);
    Vec3 height = vec3_scale(down, *entry->side * cosf(half_angle));
    Vec3 half_base = vec3_scale(sideways, *entry->side * sinf(half_angle));
    Vec3 along = vec3_scale(axis, *entry->length);
    Vec3 apex = vec3_along(vec3_from_entry(entry->apex), along, -0.5f);
    Vec3 side_1 = vec3_add(height, half_base), side_2 = vec3_sub(height, half_base);
    // axis, down and sideways are right-handed; so all edge_u × edge_v below point out of the glass.
    Flat faces[5] = {
        {apex, along, side_1, material, 0, 0},
        {apex, side_2, along, material, 0, 0},
        {vec3_add(apex, side_2), vec3_sub(side_1, side_2), along, material, 0, 0},
        {apex, side_1, side_2, material, 0, 1},
        {vec3_add(apex, along), side_2, side_1, material, 0, 1},
    };
    for (int i = 0; i < 5; i++) {
        if (flat_is_degenerate(faces[i].edge_u, faces[i].edge_v))
            return loader_fault(loader, "angle",
                                "this prism is too thin to have an inside; expected larger angle, side or length");
        if (!scene_add_flat(loader, faces[i]))
            return false;
    }
    return true;
}

static bool build_shape(SceneLoader *loader, const ShapeEntry *entry)
{
    uint32_t material = NO_MATERIAL;
    if (entry->material && !scene_find_material(loader, entry->material, &material)) {
        char suggestion[400];
        scene_suggest_material(loader, entry->material, suggestion, sizeof suggestion);
        return loader_fault(loader, "material", "there is no material '%s'; %s", entry->material, suggestion);
    }
    switch ((ShapeType)entry->type) {
    case SHAPE_SPHERE:
        return build_sphere(loader, entry, material);
    case SHAPE_RECTANGLE:
        return build_rectangle(loader, entry, material);
    case SHAPE_BOX:
        return build_box(loader, entry, material);
    case SHAPE_PRISM:
        return build_prism(loader, entry, material);
    default:
        return scene_build_mesh(loader, entry, material);
    }
}

bool scene_build_shapes(SceneLoader *loader)
{
    loader->section = &shape_section;
    for (loader->index = 0; loader->index < (int)loader->entries->shapes_count; loader->index++)
        if (!build_shape(loader, &loader->entries->shapes[loader->index]))
            return false;
    return true;
}
