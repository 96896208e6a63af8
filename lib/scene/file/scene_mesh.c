// Meshes: read, placed, and made into triangles of the scene.
#include "scene/file/scene_section.h"

#include "scene/file/obj.h"
#include "base/array.h"
#include "base/text.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>

#define LARGEST_OBJ_FILE ((size_t)512 << 20) // bytes: five million triangles and more

// `axes`: where the rotations take x, y and z.
static Vec3 turned(const Vec3 axes[3], Vec3 v)
{
    return vec3_along(vec3_along(vec3_scale(axes[0], v.x), axes[1], v.y), axes[2], v.z);
}

static bool place_mesh(SceneEntry *entry, ObjMesh *mesh)
{
    Vec3 degrees = scene_three(entry, "rotate"), translate = scene_three(entry, "translate");
    float scale = scene_number(entry, "scale");
    Vec3 axes[3] = {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)};
    for (int a = 0; a < 3; a++)
        for (int i = 0; i < 3; i++)
            axes[a] = scene_rotate(axes[a], i, vec3_component(degrees, i));
    for (size_t i = 0; i < mesh->normal_count; i++)
        mesh->normals[i] = turned(axes, mesh->normals[i]);
    for (size_t i = 0; i < mesh->point_count; i++) {
        Vec3 p = vec3_along(translate, turned(axes, mesh->points[i]), scale);
        mesh->points[i] = p;
        float most = fmaxf(fabsf(p.x), fmaxf(fabsf(p.y), fabsf(p.z)));
        if (most > (float)SCENE_LARGEST_NUMBER)
            return scene_fault(entry, "scale",
                               "scale and translate put a point of the mesh %g m away; expected at most %g", most,
                               SCENE_LARGEST_NUMBER);
    }
    return true;
}

// Corner normals are kept unless one of them looks to the other side than the face: such a mesh contradicts
// itself there, and the face's own normal is the one that tells inside from outside.
static bool add_corner_normals(SceneFile *file, const ObjMesh *mesh, const ObjTriangle *triangle, Flat *flat)
{
    Scene *scene = file->scene;
    Vec3 face = vec3_cross(flat->edge_u, flat->edge_v);
    if (!array_reserve(&scene->normals, scene->normal_count + 3, &file->normal_capacity, sizeof(Vec3)))
        return scene_out_of_memory(file);
    Vec3 *corners = &scene->normals[scene->normal_count];
    for (int i = 0; i < 3; i++) {
        corners[i] = mesh->normals[triangle->normal[i]]; // turned already
        if (vec3_dot(corners[i], face) <= 0.0f)
            return true;
    }
    flat->normals = (uint32_t)(scene->normal_count + 1) & 0x7fffffffu;
    scene->normal_count += 3;
    return true;
}

static bool add_mesh(SceneEntry *entry, const ObjMesh *mesh, uint32_t unnamed)
{
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        const ObjTriangle *triangle = &mesh->triangles[i];
        const uint32_t *point = triangle->point;
        Vec3 origin = mesh->points[point[0]];
        Flat flat = {
            .origin = origin,
            .edge_u = vec3_sub(mesh->points[point[1]], origin),
            .edge_v = vec3_sub(mesh->points[point[2]], origin),
            .material = triangle->material == OBJ_NONE ? unnamed : triangle->material,
            .is_triangle = 1,
        };
        if (flat.material == NO_MATERIAL)
            return scene_fault(entry, NULL, "this mesh has faces without usemtl; expected a 'material' for them");
        if (flat_is_degenerate(flat.edge_u, flat.edge_v))
            return scene_fault(entry, NULL,
                               "a triangle of this mesh vanishes by its scale or its distance from 0; "
                               "expected a larger scale or a smaller translate");
        if (triangle->normal[0] != OBJ_NONE && !add_corner_normals(entry->file, mesh, triangle, &flat))
            return false;
        if (!scene_add_flat(entry, flat))
            return false;
    }
    return true;
}

static bool note_file(SceneFile *file, const char *path)
{
    Scene *scene = file->scene;
    size_t length = scene->mesh_files ? strlen(scene->mesh_files) : 0;
    char *files = realloc(scene->mesh_files, length + strlen(path) + 2);
    if (!files)
        return scene_out_of_memory(file);
    sprintf(files + length, "%s\n", path);
    scene->mesh_files = files;
    return true;
}

bool scene_build_mesh(SceneEntry *entry, uint32_t material)
{
    if (!entry->file->folder)
        return scene_fault(entry, "file", "meshes are not read here");
    const char *file = scene_word(entry, "file");
    char path[PATH_MAX + 1024];
    snprintf(path, sizeof path, "%s%s", file[0] == '/' ? "" : entry->file->folder, file);
    Error unread = {""};
    size_t size = 0;
    char *text = text_read_file(path, LARGEST_OBJ_FILE, &size, &unread);
    if (!text)
        return scene_fault(entry, "file", "the mesh %s", unread.message);
    ObjMesh mesh;
    ObjNames names = {scene_material_name, entry->file, entry->file->name};
    bool fine = obj_read_text(text, size, path, &names, &mesh, entry->file->error) && place_mesh(entry, &mesh) &&
                add_mesh(entry, &mesh, material) && note_file(entry->file, path);
    obj_free(&mesh);
    free(text);
    return fine;
}
