#include "scene/file/obj.h"

#include "base/array.h"
#include "scene/bvh/shape.h"
#include "scene/limits.h"
#include "scene/file/obj_lines.h"
#include "base/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST_MATERIALS 1000

typedef struct {
    ObjCursor cursor;
    const char *name;
    ObjMesh *mesh;
    uint32_t material; // of the faces to come
    Error *error;
} Reader;

typedef struct {
    uint32_t point, normal;
} Corner;

static bool fault(const Reader *reader, const char *format, ...)
{
    char what[400];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    text_make_printable(what);
    return error_set(reader->error, "%s:%ld: %s", reader->name, reader->cursor.line, what);
}

static bool memory_fault(const Reader *reader)
{
    return fault(reader, "not enough memory for this mesh");
}

// Names the word at hand, or at least the character.
static bool word_fault(const Reader *reader, const char *expected)
{
    size_t length = obj_word_length(&reader->cursor);
    length = length || reader->cursor.at == reader->cursor.end ? length : 1;
    return fault(reader, "'%.*s' is not %s", (int)(length < 40 ? length : 40), reader->cursor.at, expected);
}

static bool read_vector(Reader *reader, const char *what, Vec3 *vector)
{
    double number[3] = {0};
    int count = 0;
    // Beyond the three there may be a weight or a colour.
    for (; !obj_at_line_end(&reader->cursor) && count < 7; count++) {
        double value;
        const char *start = reader->cursor.at;
        bool fine = text_number(&reader->cursor.at, reader->cursor.end, &value) && obj_at_word_end(&reader->cursor) &&
                    fabs(value) <= SCENE_LARGEST_NUMBER;
        reader->cursor.at = fine ? reader->cursor.at : start;
        if (!fine)
            return word_fault(reader, "a number between -1e9 and 1e9");
        if (count < 3)
            number[count] = value;
    }
    if (count < 3 || !obj_at_line_end(&reader->cursor))
        return fault(reader, "a %s has %d numbers; expected 3", what, count);
    *vector = vec3((float)number[0], (float)number[1], (float)number[2]);
    return true;
}

static Vec3 *add_vector(Reader *reader, const char *what, Vec3 **list, size_t *count, size_t *capacity)
{
    Vec3 vector;
    if (!read_vector(reader, what, &vector))
        return NULL;
    Vec3 *moved = array_reserve(*list, *count, capacity, sizeof vector);
    if (!moved) {
        memory_fault(reader);
        return NULL;
    }
    *list = moved;
    moved[*count] = vector;
    return &moved[(*count)++];
}

static bool read_point(Reader *reader)
{
    ObjMesh *mesh = reader->mesh;
    return add_vector(reader, "point (v)", &mesh->points, &mesh->point_count, &mesh->point_capacity) != NULL;
}

static bool read_normal(Reader *reader)
{
    ObjMesh *mesh = reader->mesh;
    Vec3 *normal = add_vector(reader, "normal (vn)", &mesh->normals, &mesh->normal_count, &mesh->normal_capacity);
    if (!normal)
        return false;
    float length = vec3_length(*normal);
    *normal = vec3_scale(*normal, 1.0f / length);
    return length > 1e-12f || fault(reader, "a normal of length 0; expected a direction");
}

// An index counts from 1, or, when negative, back from the newest. Gives it from 0.
static bool read_index(Reader *reader, size_t count, const char *what, uint32_t *index)
{
    const char *start = reader->cursor.at, *end = reader->cursor.end, *p = start;
    bool negative = p < end && *p == '-';
    uint64_t number = 0;
    const char *digits = p += negative;
    for (; p < end && *p >= '0' && *p <= '9'; p++)
        number = number > UINT32_MAX ? number : number * 10 + (uint64_t)(*p - '0');
    if (p == digits)
        return word_fault(reader, "a corner; expected point, point/texture, point//normal or point/texture/normal");
    if (number == 0 || number > count)
        return fault(reader, "there is no %s %.*s: %zu stand above, counted from 1", what,
                     (int)(p - start < 30 ? p - start : 30), start, count);
    *index = (uint32_t)(negative ? count - number : number - 1);
    reader->cursor.at = p;
    return true;
}

// A '/' that is there is gone over.
static bool at_slash(Reader *reader)
{
    bool slash = reader->cursor.at < reader->cursor.end && *reader->cursor.at == '/';
    reader->cursor.at += slash;
    return slash;
}

// One of 7, 7/1, 7//3, 7/1/3. Texture coordinates, in the middle, are not used.
static bool read_corner(Reader *reader, Corner *corner)
{
    corner->normal = OBJ_NONE;
    if (!read_index(reader, reader->mesh->point_count, "point", &corner->point))
        return false;
    if (at_slash(reader)) {
        while (reader->cursor.at < reader->cursor.end && memchr("-0123456789", *reader->cursor.at, 11))
            reader->cursor.at++;
        if (at_slash(reader) && !read_index(reader, reader->mesh->normal_count, "normal", &corner->normal))
            return false;
    }
    return obj_at_word_end(&reader->cursor) || word_fault(reader, "the end of a corner; expected a blank");
}

static bool has_area(const ObjMesh *mesh, Corner a, Corner b, Corner c)
{
    Vec3 origin = mesh->points[a.point];
    return !flat_is_degenerate(vec3_sub(mesh->points[b.point], origin), vec3_sub(mesh->points[c.point], origin));
}

static bool add_triangle(const Reader *reader, Corner a, Corner b, Corner c)
{
    ObjMesh *mesh = reader->mesh;
    ObjTriangle *triangle =
        array_reserve(mesh->triangles, mesh->triangle_count, &mesh->triangle_capacity, sizeof *triangle);
    if (!triangle)
        return memory_fault(reader);
    mesh->triangles = triangle;
    triangle += mesh->triangle_count++;
    *triangle = (ObjTriangle){{a.point, b.point, c.point}, {a.normal, b.normal, c.normal}, reader->material};
    if (a.normal == OBJ_NONE || b.normal == OBJ_NONE || c.normal == OBJ_NONE)
        triangle->normal[0] = triangle->normal[1] = triangle->normal[2] = OBJ_NONE;
    return true;
}

static bool read_face(Reader *reader)
{
    Corner first = {0, 0}, previous = {0, 0}, corner;
    size_t before = reader->mesh->triangle_count;
    int count = 0;
    for (; !obj_at_line_end(&reader->cursor); count += count < 3, previous = corner) {
        if (!read_corner(reader, &corner))
            return false;
        if (count == 0)
            first = corner;
        if (count >= 2 && has_area(reader->mesh, first, previous, corner) &&
            !add_triangle(reader, first, previous, corner))
            return false;
    }
    if (count < 3)
        return fault(reader, "a face of %d corner%s; expected at least 3", count, count == 1 ? "" : "s");
    return reader->mesh->triangle_count > before ||
           fault(reader, "a face without area: its corners coincide or lie in a line; remove it or move a corner");
}

static bool read_usemtl(Reader *reader)
{
    ObjMesh *mesh = reader->mesh;
    obj_skip_blanks(&reader->cursor);
    size_t length = obj_rest_length(&reader->cursor);
    if (length == 0 || length >= sizeof mesh->materials->name || memchr(reader->cursor.at, '\0', length))
        return fault(reader, "usemtl with a name of %zu characters; expected 1 to 63", length);
    for (size_t i = 0; i < mesh->material_count; i++) {
        const char *name = mesh->materials[i].name;
        if (strlen(name) == length && memcmp(name, reader->cursor.at, length) == 0) {
            reader->material = (uint32_t)i;
            return true;
        }
    }
    if (mesh->material_count == MOST_MATERIALS)
        return fault(reader, "more than %d materials; expected fewer", MOST_MATERIALS);
    ObjMaterial *material =
        array_reserve(mesh->materials, mesh->material_count, &mesh->material_capacity, sizeof *material);
    if (!material)
        return memory_fault(reader);
    mesh->materials = material;
    material += mesh->material_count;
    *material = (ObjMaterial){.line = reader->cursor.line};
    memcpy(material->name, reader->cursor.at, length);
    reader->material = (uint32_t)mesh->material_count++;
    return true;
}

// Keywords of the format that say nothing about surfaces of flat polygons.
static bool is_unused_keyword(const char *word, size_t length)
{
    static const char unused[] =
        " vt vp g o s l p mtllib usemap maplib cstype deg bmat step curv curv2 surf parm trim hole scrv sp "
        "end con mg "
        "bevel c_interp d_interp lod shadow_obj trace_obj ctech stech bzp bsp cdc cdp res call csh ";
    char padded[16] = " ";
    if (length > sizeof padded - 3)
        return false;
    memcpy(padded + 1, word, length);
    padded[length + 1] = ' ';
    return strstr(unused, padded) != NULL;
}

static bool read_statement(Reader *reader)
{
    const char *word = reader->cursor.at;
    size_t length = obj_word_length(&reader->cursor);
    reader->cursor.at += length;
    if (length == 1 && *word == 'v')
        return read_point(reader);
    if (length == 2 && memcmp(word, "vn", 2) == 0)
        return read_normal(reader);
    if (length == 1 && *word == 'f')
        return read_face(reader);
    if (length == 6 && memcmp(word, "usemtl", 6) == 0)
        return read_usemtl(reader);
    if (is_unused_keyword(word, length))
        return true;
    reader->cursor.at = word;
    return word_fault(reader, "a keyword of an OBJ file; expected v, vn, vt, f, usemtl, g, o, s or mtllib");
}

bool obj_read_text(const char *text, size_t size, const char *name, ObjMesh *mesh, Error *error)
{
    *mesh = (ObjMesh){0};
    Reader reader = {
        .cursor = {text, text + size, 1}, .name = name, .mesh = mesh, .material = OBJ_NONE, .error = error};
    if (size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0)
        reader.cursor.at += 3; // the mark that some editors put before UTF-8
    for (; reader.cursor.at < reader.cursor.end; obj_next_line(&reader.cursor))
        if (!obj_at_line_end(&reader.cursor) && !read_statement(&reader))
            return false;
    return mesh->triangle_count > 0 || fault(&reader, "the file ends without a face; expected lines like 'f 1 2 3'");
}

void obj_free(ObjMesh *mesh)
{
    free(mesh->points);
    free(mesh->normals);
    free(mesh->triangles);
    free(mesh->materials);
    *mesh = (ObjMesh){0};
}
