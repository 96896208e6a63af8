#include "scene/file/obj.h"

#include "base/array.h"
#include "scene/bvh/shape.h"
#include "scene/limits.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Goes through the text word by word: comments reach from # to the line's end, a backslash there carries the line on.
typedef struct {
    const char *at, *word_end; // what is left of the word at hand
    const char *end;           // of the text
    long line;                 // from 1
    const char *name;
    const ObjNames *names;
    ObjMesh *mesh;
    uint32_t material; // of the faces to come
    Error *error;
} ObjReader;

typedef struct {
    uint32_t point, normal;
} Corner;

// "name:line: …" in the error; always false.
static PRINTF_LIKE(2, 3) bool fault(const ObjReader *reader, const char *format, ...)
{
    char what[700];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    return error_set(reader->error, "%s:%ld: %s", reader->name, reader->line, what);
}

// "'7x' is not …": what is left of the word, or at least the character behind it.
static bool word_fault(const ObjReader *reader, const char *expected)
{
    size_t length = (size_t)(reader->word_end - reader->at);
    length = length || reader->at == reader->end ? length : 1;
    return fault(reader, "'%.*s' is not %s", (int)(length < 40 ? length : 40), reader->at, expected);
}

// The length of a blank, or of a backslash and the line's end behind it; 0 when there is no such thing here.
static size_t blank_length(const char *at, const char *end)
{
    if (memchr(" \t\r", *at, 3))
        return 1;
    size_t left = (size_t)(end - at), length = left > 2 && at[1] == '\r' ? 3 : 2;
    return *at == '\\' && left >= length && at[length - 1] == '\n' ? length : 0;
}

// Goes on to the next word of the line. False, and none is at hand, at the line's end.
static bool next_word(ObjReader *reader)
{
    const char *at = reader->word_end, *end = reader->end;
    for (size_t length; at < end && (length = blank_length(at, end)); at += length)
        reader->line += length > 1;
    reader->at = reader->word_end = at;
    if (at == end || *at == '\n' || *at == '#')
        return false;
    static const bool ends[256] = {[' '] = 1, ['\t'] = 1, ['\r'] = 1, ['\n'] = 1, ['\\'] = 1, ['#'] = 1};
    while (at < end && !ends[(unsigned char)*at]) // of a mesh's millions of characters, most come by here
        at++;
    reader->word_end = at > reader->at ? at : at + 1; // a backslash inside a line is a word
    return true;
}

// Goes on to the next line, at whose first word nobody has looked yet.
static void next_line(ObjReader *reader)
{
    while (next_word(reader))
        ;
    const char *newline = memchr(reader->at, '\n', (size_t)(reader->end - reader->at));
    reader->word_end = newline ? newline + 1 : reader->end;
    reader->line += newline != NULL;
}

static bool word_is(const ObjReader *reader, const char *word)
{
    size_t length = (size_t)(reader->word_end - reader->at);
    return strlen(word) == length && memcmp(word, reader->at, length) == 0;
}

// Reads three numbers to the end of a list.
static bool read_vector(ObjReader *reader, const char *what, Vec3 **list, size_t *count, size_t *capacity)
{
    double number[7] = {0}; // beyond the three there may be a weight or a colour
    int read = 0;
    bool more;
    for (; (more = next_word(reader)) && read < 7; read++) {
        const char *at = reader->at;
        if (!text_number(&at, reader->word_end, &number[read]) || at < reader->word_end ||
            fabs(number[read]) > SCENE_LARGEST_NUMBER)
            return word_fault(reader, "a number between -1e9 and 1e9");
    }
    if (read < 3 || more)
        return fault(reader, "a %s has %d numbers; expected 3", what, read);
    if (!array_reserve(list, *count + 1, capacity, sizeof **list))
        return fault(reader, "not enough memory for this mesh");
    (*list)[(*count)++] = vec3((float)number[0], (float)number[1], (float)number[2]);
    return true;
}

static bool read_normal(ObjReader *reader)
{
    ObjMesh *mesh = reader->mesh;
    if (!read_vector(reader, "normal (vn)", &mesh->normals, &mesh->normal_count, &mesh->normal_capacity))
        return false;
    Vec3 *normal = &mesh->normals[mesh->normal_count - 1];
    float length = vec3_length(*normal);
    *normal = vec3_scale(*normal, 1.0f / length);
    return length > 1e-12f || fault(reader, "a normal of length 0; expected a direction");
}

// An index counts from 1, or, when negative, back from the newest. Gives it from 0.
static bool read_index(ObjReader *reader, size_t count, const char *what, uint32_t *index)
{
    const char *start = reader->at, *p = start;
    bool negative = p < reader->word_end && *p == '-';
    uint64_t number = 0;
    const char *digits = p += negative;
    for (; p < reader->word_end && isdigit((unsigned char)*p); p++)
        number = number > UINT32_MAX ? number : number * 10 + (uint64_t)(*p - '0');
    if (p == digits)
        return word_fault(reader, "a corner; expected point, point/texture, point//normal or point/texture/normal");
    if (number == 0 || number > count)
        return fault(reader, "there is no %s %.*s: %zu stand above, counted from 1", what,
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
        while (reader->at < reader->word_end && (*reader->at == '-' || isdigit((unsigned char)*reader->at)))
            reader->at++;
        if (skip_slash(reader) && !read_index(reader, reader->mesh->normal_count, "normal", &corner->normal))
            return false;
    }
    return reader->at == reader->word_end || word_fault(reader, "the end of a corner; expected a blank");
}

// Of a fan; those without area are left out.
static bool add_triangle(const ObjReader *reader, Corner a, Corner b, Corner c)
{
    ObjMesh *mesh = reader->mesh;
    Vec3 origin = mesh->points[a.point];
    if (flat_is_degenerate(vec3_sub(mesh->points[b.point], origin), vec3_sub(mesh->points[c.point], origin)))
        return true;
    if (!array_reserve(&mesh->triangles, mesh->triangle_count + 1, &mesh->triangle_capacity, sizeof(ObjTriangle)))
        return fault(reader, "not enough memory for this mesh");
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
    for (; next_word(reader); count += count < 3, previous = corner) {
        if (!read_corner(reader, &corner))
            return false;
        if (count == 0)
            first = corner;
        if (count >= 2 && !add_triangle(reader, first, previous, corner))
            return false;
    }
    if (count < 3)
        return fault(reader, "a face of %d corner%s; expected at least 3", count, count == 1 ? "" : "s");
    return reader->mesh->triangle_count > before ||
           fault(reader, "a face without area: its corners coincide or lie in a line; remove it or move a corner");
}

// The name is what is left of the line, without a comment and the blanks at its end.
static bool read_usemtl(ObjReader *reader)
{
    next_word(reader);
    size_t length = 0;
    char name[64] = "";
    for (const char *p = reader->at; p < reader->end && *p != '\n'; p++) {
        if (*p == '#' && length < (size_t)(p - reader->at))
            break; // behind a blank; a name may hold the sign inside
        if (!memchr(" \t\r", *p, 3))
            length = (size_t)(p - reader->at) + 1;
    }
    if (length == 0 || length >= sizeof name || memchr(reader->at, '\0', length))
        return fault(reader, "usemtl with a name of %zu characters; expected 1 to 63", length);
    memcpy(name, reader->at, length);
    reader->word_end = reader->at + length;
    const ObjNames *names = reader->names;
    size_t number;
    if (!text_find_name(name, names->name_at, names->list, &number))
        return fault(reader, "usemtl '%s' is no material of %s; %s", name, names->of,
                     text_suggest(name, names->name_at, names->list).text);
    reader->material = (uint32_t)number;
    return true;
}

// Keywords of the format that say nothing about surfaces of flat polygons, with a blank on each side.
static const char unused_keywords[] =
    " vt vp g o s l p mtllib usemap maplib cstype deg bmat step curv curv2 surf parm trim hole scrv sp end con mg "
    "bevel c_interp d_interp lod shadow_obj trace_obj ctech stech bzp bsp cdc cdp res call csh ";

static bool read_statement(ObjReader *reader)
{
    ObjMesh *mesh = reader->mesh;
    if (word_is(reader, "v"))
        return read_vector(reader, "point (v)", &mesh->points, &mesh->point_count, &mesh->point_capacity);
    if (word_is(reader, "vn"))
        return read_normal(reader);
    if (word_is(reader, "f"))
        return read_face(reader);
    if (word_is(reader, "usemtl"))
        return read_usemtl(reader);
    char padded[16] = "";
    snprintf(padded, sizeof padded, " %.*s ", (int)(reader->word_end - reader->at), reader->at);
    return strstr(unused_keywords, padded) ||
           word_fault(reader, "a keyword of an OBJ file; expected v, vn, vt, f, usemtl, g, o, s or mtllib");
}

bool obj_read_text(const char *text, size_t size, const char *name, const ObjNames *names, ObjMesh *mesh, Error *error)
{
    *mesh = (ObjMesh){0};
    bool mark = size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0; // that some editors put before UTF-8
    const char *start = text + (mark ? 3 : 0);
    ObjReader reader = {start, start, text + size, 1, name, names, mesh, OBJ_NONE, error};
    for (; reader.word_end < reader.end; next_line(&reader))
        if (next_word(&reader) && !read_statement(&reader))
            return false;
    return mesh->triangle_count > 0 || fault(&reader, "the file ends without a face; expected lines like 'f 1 2 3'");
}

void obj_free(ObjMesh *mesh)
{
    free(mesh->points);
    free(mesh->normals);
    free(mesh->triangles);
    *mesh = (ObjMesh){0};
}
