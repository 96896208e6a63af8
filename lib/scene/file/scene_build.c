#include "scene/file/scene_section.h"

#include "base/array.h"

bool scene_add_flat(SceneBuilder *builder, Flat flat)
{
    Scene *scene = builder->scene;
    if (!array_reserve(&scene->flats, scene->flat_count + 1, &builder->flat_capacity, sizeof flat))
        return scene_out_of_memory(&builder->file);
    scene->flats[scene->flat_count++] = flat;
    return true;
}

bool scene_add_sphere(SceneBuilder *builder, Sphere sphere)
{
    builder->scene->spheres[builder->scene->sphere_count++] = sphere;
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
