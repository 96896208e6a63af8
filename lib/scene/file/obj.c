#include "scene/file/obj_words.h"

#include "base/array.h"
#include "scene/bvh/shape.h"
#include "scene/limits.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    uint32_t point, normal;
} Corner;

static bool memory_fault(const ObjReader *reader)
{
    return obj_fault(reader, "not enough memory for this mesh");
}

// Reads three numbers to the end of a list; gives their place there, or NULL.
static Vec3 *read_vector(ObjReader *reader, const char *what, Vec3 **list, size_t *count, size_t *capacity)
{
    double number[7] = {0}; // beyond the three there may be a weight or a colour
    int read = 0;
    bool more;
    for (; (more = obj_next_word(reader)) && read < 7; read++) {
        const char *at = reader->at;
        if (!text_number(&at, reader->word_end, &number[read]) || at < reader->word_end ||
            fabs(number[read]) > SCENE_LARGEST_NUMBER) {
            obj_word_fault(reader, "a number between -1e9 and 1e9");
            return NULL;
        }
    }
    if (read < 3 || more) {
        obj_fault(reader, "a %s has %d numbers; expected 3", what, read);
        return NULL;
    }
    if (!array_reserve(list, *count + 1, capacity, sizeof **list)) {
        memory_fault(reader);
        return NULL;
    }
    (*list)[*count] = vec3((float)number[0], (float)number[1], (float)number[2]);
    return &(*list)[(*count)++];
}

static bool read_normal(ObjReader *reader)
{
    ObjMesh *mesh = reader->mesh;
    Vec3 *normal = read_vector(reader, "normal (vn)", &mesh->normals, &mesh->normal_count, &mesh->normal_capacity);
    if (!normal)
        return false;
    float length = vec3_length(*normal);
    *normal = vec3_scale(*normal, 1.0f / length);
    return length > 1e-12f || obj_fault(reader, "a normal of length 0; expected a direction");
}

// An index counts from 1, or, when negative, back from the newest. Gives it from 0.
static bool read_index(ObjReader *reader, size_t count, const char *what, uint32_t *index)
{
    const char *start = reader->at, *p = start;
    bool negative = p < reader->word_end && *p == '-';
    uint64_t number = 0;
    const char *digits = p += negative;
    for (; p < reader->word_end && *p >= '0' && *p <= '9'; p++)
        number = number > UINT32_MAX ? number : number * 10 + (uint64_t)(*p - '0');
    if (p == digits)
        return obj_word_fault(reader, "a corner; expected point, point/texture, point//normal or point/texture/normal");
    if (number == 0 || number > count)
        return obj_fault(reader, "there is no %s %.*s: %zu stand above, counted from 1", what,
                         (int)(p - start < 30 ? p - start : 30), start, count);
    *index = (uint32_t)(negative ? count - number : number - 1);
    reader->at = p;
    return true;
}

// A '/' that is there is gone over.
static bool skip_slash(ObjReader *reader)
{
    bool slash = reader->at < reader->word_end && *reader->at == '/';
    reader->at += slash;
    return slash;
}

// One of 7, 7/1, 7//3, 7/1/3. Texture coordinates, in the middle, are not used.
static bool read_corner(ObjReader *reader, Corner *corner)
{
    corner->normal = OBJ_NONE;
    if (!read_index(reader, reader->mesh->point_count, "point", &corner->point))
        return false;
    if (skip_slash(reader)) {
        while (reader->at < reader->word_end && is_one_of(*reader->at, "-0123456789"))
            reader->at++;
        if (skip_slash(reader) && !read_index(reader, reader->mesh->normal_count, "normal", &corner->normal))
            return false;
    }
    return reader->at == reader->word_end || obj_word_fault(reader, "the end of a corner; expected a blank");
}

// Of a fan; those without area are left out.
static bool add_triangle(const ObjReader *reader, Corner a, Corner b, Corner c)
{
    ObjMesh *mesh = reader->mesh;
    Vec3 origin = mesh->points[a.point];
    if (flat_is_degenerate(vec3_sub(mesh->points[b.point], origin), vec3_sub(mesh->points[c.point], origin)))
        return true;
    if (!array_reserve(&mesh->triangles, mesh->triangle_count + 1, &mesh->triangle_capacity, sizeof(ObjTriangle)))
        return memory_fault(reader);
    ObjTriangle *triangle = &mesh->triangles[mesh->triangle_count++];
    *triangle = (ObjTriangle){{a.point, b.point, c.point}, {a.normal, b.normal, c.normal}, reader->material};
    if (a.normal == OBJ_NONE || b.normal == OBJ_NONE || c.normal == OBJ_NONE)
        triangle->normal[0] = triangle->normal[1] = triangle->normal[2] = OBJ_NONE;
    return true;
}

static bool read_face(ObjReader *reader)
{
    Corner first = {0, 0}, previous = {0, 0}, corner;
    size_t before = reader->mesh->triangle_count;
    int count = 0;
    for (; obj_next_word(reader); count += count < 3, previous = corner) {
        if (!read_corner(reader, &corner))
            return false;
        if (count == 0)
            first = corner;
        if (count >= 2 && !add_triangle(reader, first, previous, corner))
            return false;
    }
    if (count < 3)
        return obj_fault(reader, "a face of %d corner%s; expected at least 3", count, count == 1 ? "" : "s");
    return reader->mesh->triangle_count > before ||
           obj_fault(reader, "a face without area: its corners coincide or lie in a line; remove it or move a corner");
}

// The name is what is left of the line, without a comment and the blanks at its end.
static bool read_usemtl(ObjReader *reader)
{
    obj_next_word(reader);
    size_t length = 0;
    char name[64] = "";
    for (const char *p = reader->at; p < reader->end && *p != '\n'; p++) {
        if (*p == '#' && length < (size_t)(p - reader->at))
            break; // behind a blank; a name may hold the sign inside
        if (!is_one_of(*p, " \t\r"))
            length = (size_t)(p - reader->at) + 1;
    }
    if (length == 0 || length >= sizeof name || memchr(reader->at, '\0', length))
        return obj_fault(reader, "usemtl with a name of %zu characters; expected 1 to 63", length);
    memcpy(name, reader->at, length);
    reader->word_end = reader->at + length;
    const ObjNames *names = reader->names;
    size_t number;
    if (text_find_name(name, names->name_at, names->list, &number)) {
        reader->material = (uint32_t)number;
        return true;
    }
    return obj_fault(reader, "usemtl '%s' is no material of %s; %s", name, names->of,
                     text_suggest(name, names->name_at, names->list).text);
}

// Keywords of the format that say nothing about surfaces of flat polygons, with a blank on each side.
static const char unused_keywords[] =
    " vt vp g o s l p mtllib usemap maplib cstype deg bmat step curv curv2 surf parm trim hole scrv sp end con mg "
    "bevel c_interp d_interp lod shadow_obj trace_obj ctech stech bzp bsp cdc cdp res call csh ";

static bool read_statement(ObjReader *reader)
{
    ObjMesh *mesh = reader->mesh;
    if (obj_word_is(reader, "v"))
        return read_vector(reader, "point (v)", &mesh->points, &mesh->point_count, &mesh->point_capacity);
    if (obj_word_is(reader, "vn"))
        return read_normal(reader);
    if (obj_word_is(reader, "f"))
        return read_face(reader);
    if (obj_word_is(reader, "usemtl"))
        return read_usemtl(reader);
    char padded[16] = "";
    snprintf(padded, sizeof padded, " %.*s ", (int)(reader->word_end - reader->at), reader->at);
    return strstr(unused_keywords, padded) ||
           obj_word_fault(reader, "a keyword of an OBJ file; expected v, vn, vt, f, usemtl, g, o, s or mtllib");
}

bool obj_read_text(const char *text, size_t size, const char *name, const ObjNames *names, ObjMesh *mesh, Error *error)
{
    *mesh = (ObjMesh){0};
    bool mark = size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0; // that some editors put before UTF-8
    ObjReader reader = {.word_end = text + (mark ? 3 : 0),
                        .end = text + size,
                        .line = 1,
                        .name = name,
                        .names = names,
                        .mesh = mesh,
                        .material = OBJ_NONE,
                        .error = error};
    for (; reader.word_end < reader.end; obj_next_line(&reader))
        if (obj_next_word(&reader) && !read_statement(&reader))
            return false;
    return mesh->triangle_count > 0 ||
           obj_fault(&reader, "the file ends without a face; expected lines like 'f 1 2 3'");
}

void obj_free(ObjMesh *mesh)
{
    free(mesh->points);
    free(mesh->normals);
    free(mesh->triangles);
    *mesh = (ObjMesh){0};
}
