// What building lights and shapes needs of the scene half made.
#ifndef PHOTONLAB_SCENE_SCENE_BUILD_H
#define PHOTONLAB_SCENE_SCENE_BUILD_H

#include "scene/file/scene_section.h"

#define NO_MATERIAL UINT32_MAX

// The count of flats, spheres or normals grows. False when memory is short.
bool scene_add_flat(SceneBuilder *builder, Flat flat);
bool scene_add_sphere(SceneBuilder *builder, Sphere sphere);
bool scene_add_normals(SceneBuilder *builder, const Vec3 corners[3]);

// May these be sides of a flat? If not, says why at `key`.
bool scene_check_edges(const SceneEntry *entry, const char *key, Vec3 edge_u, Vec3 edge_v);

// Name number i of the file's materials, NULL past the last: a TextNameAt of the builder.
const char *scene_material_name(const void *builder, size_t i);

// A mesh's triangles; `material` for faces without usemtl, NO_MATERIAL when there is none.
bool scene_build_mesh(SceneBuilder *builder, SceneEntry *entry, uint32_t material);

// Turns by an angle in degrees about axis 0, 1 or 2, counter-clockwise for who looks against the axis.
Vec3 scene_rotate(Vec3 p, int axis, float degrees);

#endif
