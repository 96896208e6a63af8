#include "scene/file/scene_build.h"

#include "base/array.h"
#include "base/text.h"

#include <string.h>

// Puts an item behind the last of a list; gives the list, moved if need be, or NULL.
static void *append(const SceneBuilder *builder, void *list, size_t *count, size_t *capacity, const void *item,
                    size_t item_size)
{
    char *moved = array_reserve(list, *count, capacity, item_size);
    if (!moved) {
        error_set(builder->file.error, "%s: not enough memory for lights and shapes", builder->file.name);
        return NULL;
    }
    memcpy(moved + *count * item_size, item, item_size);
    ++*count;
    return moved;
}

bool scene_add_light(SceneBuilder *builder, const Light *light)
{
    Scene *scene = builder->scene;
    Light *lights =
        append(builder, scene->lights, &scene->light_count, &builder->light_capacity, light, sizeof *lights);
    scene->lights = lights ? lights : scene->lights;
    return lights != NULL;
}

bool scene_add_flat(SceneBuilder *builder, Flat flat)
{
    Scene *scene = builder->scene;
    Flat *flats = append(builder, scene->flats, &scene->flat_count, &builder->flat_capacity, &flat, sizeof flat);
    scene->flats = flats ? flats : scene->flats;
    return flats != NULL;
}

bool scene_add_sphere(SceneBuilder *builder, Sphere sphere)
{
    Scene *scene = builder->scene;
    Sphere *spheres =
        append(builder, scene->spheres, &scene->sphere_count, &builder->sphere_capacity, &sphere, sizeof sphere);
    scene->spheres = spheres ? spheres : scene->spheres;
    return spheres != NULL;
}

bool scene_add_normals(SceneBuilder *builder, const Vec3 corners[3])
{
    Scene *scene = builder->scene;
    for (int i = 0; i < 3; i++) {
        Vec3 *normals = append(builder, scene->normals, &scene->normal_count, &builder->normal_capacity, &corners[i],
                               sizeof *normals);
        if (!normals)
            return false;
        scene->normals = normals;
    }
    return true;
}

bool scene_check_edges(const SceneEntry *entry, const char *key, Vec3 edge_u, Vec3 edge_v)
{
    return !flat_is_degenerate(edge_u, edge_v) ||
           scene_fault(entry, key,
                       "edge_u (%g, %g, %g) and edge_v (%g, %g, %g) are zero or parallel; expected two sides "
                       "that span an area",
                       edge_u.x, edge_u.y, edge_u.z, edge_v.x, edge_v.y, edge_v.z);
}

const char *scene_material_name(const void *builder, size_t i)
{
    const SceneBuilder *of = builder;
    return i < of->file_materials ? of->scene->materials[i].name : NULL;
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
