// The parts of loading a scene that scene_load.c calls one after the other. Not for use outside the loader,
// except for scene_load_text in tests.
#ifndef PHOTONLAB_SCENE_SCENE_LOAD_H
#define PHOTONLAB_SCENE_SCENE_LOAD_H

#include "scene/limits.h"
#include "scene/scene.h"
#include "scene/file/scene_schema.h"

#define NO_MATERIAL UINT32_MAX

typedef struct {
    const char *file;   // name of the scene file, for messages
    const char *text;   // what it says
    size_t size;        // bytes of it
    const char *folder; // where meshes are looked for, with a slash at its end; NULL: none are read
    const SceneEntries *entries;
    const SceneSection *section; // the entry at hand: shapes[index]; index −1 in camera and render
    int index;
    Scene *scene; // what is being built
    size_t flat_capacity, sphere_capacity, normal_capacity;
    Error *error;
} SceneLoader;

// scene_load from memory. `file` names the text in messages; `folder` NULL refuses meshes.
Scene *scene_load_text(const char *text, size_t size, const char *file, const char *folder, Error *error);

// Writes "file:line:column: …" with the place of `key` ("radius", "radiance[1]") in the entry at hand (NULL:
// of the entry itself). Always false.
bool loader_fault(const SceneLoader *loader, const char *key, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 3, 4)))
#endif
    ;

// Are all entries' keys those of their type, and all numbers in their range?
bool scene_validate(SceneLoader *loader);

// Each builds one part of loader->scene from entries that were validated, and refuses what only shows in
// combination.
bool scene_build_camera(SceneLoader *loader);
bool scene_build_materials(SceneLoader *loader);
bool scene_build_lights(SceneLoader *loader); // with their surfaces; a sphere's primitive still counts from 0
bool scene_build_shapes(SceneLoader *loader);

// Used by lights and shapes. The count of flats or spheres grows by one; false when memory is short.
bool scene_add_flat(SceneLoader *loader, Flat flat);
bool scene_add_sphere(SceneLoader *loader, Sphere sphere);
bool scene_add_normals(SceneLoader *loader, const Vec3 corners[3]);

// May these be sides of a flat? If not, says why at `key`.
bool scene_check_edges(const SceneLoader *loader, const char *key, Vec3 edge_u, Vec3 edge_v);

// The number of a material of the file; false, and *material unchanged, when there is none of that name.
bool scene_find_material(const SceneLoader *loader, const char *name, uint32_t *material);
// "did you mean …" for a name that is none.
void scene_suggest_material(const SceneLoader *loader, const char *name, char *message, size_t size);

// A mesh's triangles; `material` for faces without usemtl, NO_MATERIAL when there is none.
bool scene_build_mesh(SceneLoader *loader, const ShapeEntry *entry, uint32_t material);

// Turns by an angle in degrees about axis 0, 1 or 2, counter-clockwise for who looks against the axis.
Vec3 scene_rotate(Vec3 p, int axis, float degrees);

static inline Vec3 vec3_from_entry(const float *three)
{
    return vec3(three[0], three[1], three[2]);
}

static inline Colour colour_from_entry(const float *three)
{
    return colour(three[0], three[1], three[2]);
}

#endif
