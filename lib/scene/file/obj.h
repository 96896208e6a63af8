// Wavefront OBJ meshes: points, corner normals, polygons and names of materials. What else a file may hold
// (texture coordinates, groups, smoothing groups, lines, curves) is read over; an unknown keyword is an
// error.
#pragma once

#include "base/text.h"
#include "math/vec3.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define OBJ_NONE UINT32_MAX

typedef struct {
    uint32_t point[3];  // into ObjMesh.points, counter-clockwise seen from outside
    uint32_t normal[3]; // into ObjMesh.normals; OBJ_NONE for all three or for none
    uint32_t material;  // number of the name behind usemtl; OBJ_NONE before the first
} ObjTriangle;

// The names that may stand behind usemtl, and for messages what they are the materials of.
typedef struct {
    TextNameAt name_at;
    const void *list;
    const char *of;
} ObjNames;

typedef struct {
    Vec3 *points, *normals; // normals are unit
    ObjTriangle *triangles;
    size_t point_count, normal_count, triangle_count;
    size_t point_capacity, normal_capacity, triangle_capacity;
} ObjMesh;

// Reads the text of a file; `name` stands for the file in messages. Fills *mesh; the caller frees it with
// obj_free, also after a failure. False with "file:line: what is wrong; what was expected" when a line cannot
// be read, refers to points that do not stand above it, is a face without area or a normal of no length, asks for an
// unknown material, or when there are no faces at all. A polygon becomes a fan about its first corner, which is right for convex
// ones only; of its triangles those without area are left out as long as one remains. Indices of texture
// coordinates are not checked.
bool obj_read_text(const char *text, size_t size, const char *name, const ObjNames *names, ObjMesh *mesh, Error *error);
void obj_free(ObjMesh *mesh);
