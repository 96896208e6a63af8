#include "scene/export/export.h"
#include "scene/material_kind.h"
#include "base/file.h"
#include "base/text.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#define EXPORT_FORMAT(name) &export_##name,
static const ExportFormat *const formats[] = {
#include "scene/export/formats.def"
};

const ExportFormat *export_format(const char *path, Error *error)
{
    char known[200] = "";
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
        if (file_ends_in(path, formats[i]->ending))
            return formats[i];
        text_append(known, sizeof known, "%s%s (%s)", i == 0 ? "" : " or ", formats[i]->ending, formats[i]->renderer);
    }
    error_set(error, "%s: unknown ending; expected %s", path, known);
    return NULL;
}

void export_note(const Export *e, const char *format, ...)
{
    char words[400];
    if (!e->note)
        return;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(words, sizeof words, format, arguments);
    va_end(arguments);
    e->note(words);
}

// Each channel of a reflectance as that of one part of a mixture, which has this share in it.
static Colour part(Colour whole, float share)
{
    if (share <= 0.0f)
        return colour_grey(0.0f);
    return colour(fminf(whole.r / share, 1.0f), fminf(whole.g / share, 1.0f), fminf(whole.b / share, 1.0f));
}

// cosⁿα ≈ exp(−nα²/2) about the mirror direction; a facet turns by half of α, and Beckmann's facets lie as exp(−tan²θ/roughness²).
static ExportGlossy glossy_of(const Export *e, const Material *material)
{
    float diffuse = colour_max(material->diffuse), specular = colour_max(material->specular);
    float share = specular > 0.0f ? specular / (diffuse + specular) : 0.0f;
    float roughness = fminf(1.0f, 1.0f / sqrtf(2.0f * fmaxf(material->exponent, 0.5f)));
    export_note(e,
                "%s: the cosine lobe of exponent %g is approximated, by microfacets of roughness %.3g: %s has no Phong",
                material->name, material->exponent, roughness, e->format->renderer);
    return (ExportGlossy){share, part(material->diffuse, 1.0f - share), part(material->specular, share), roughness};
}

// One that does not shine. False, with the error: it reflects by a rule of its own.
static bool declare(const Export *e, const Material *material, const char *name)
{
    const MaterialKind *kind = material_kind(material);
    if (kind->cosine_lobe)
        e->format->glossy(e, name, glossy_of(e, material));
    else if (kind->optics == OPTICS_ROUGH && !kind->lobe)
        e->format->diffuse(e, name, material->diffuse);
    else if (kind == &material_mirror)
        e->format->mirror(e, name, material);
    else if (kind->optics == OPTICS_GLASS)
        e->format->glass(e, name, material);
    else
        return error_set(e->error, "the material '%s' treats light by a rule of its own, which %s does not know",
                         material->name, e->format->renderer);
    return true;
}

// One without a surface.
static void write_light(const Export *e, const Light *light)
{
    float share = light->type == LIGHT_SPOT ? 0.5f * (1.0f - light->cos_cone) : 1.0f; // of all directions
    if (light->type == LIGHT_BEAM)
        export_note(e,
                    "a beam is left out: %s has no lamp of parallel light with an edge that a path tracer could find",
                    e->format->renderer);
    else
        e->format->light(e, light, colour_scale(light->power, 1.0f / (4.0f * PI * share)));
}

// Corners are not shared: flats keep their edges.
static void write_flat(const Scene *scene, const Flat *flat, bool with_normals, FILE *stream)
{
    Vec3 even[3] = {flat->normal, flat->normal, flat->normal};
    const Vec3 *normals = flat->normals ? &scene->normals[flat->normals - 1] : even;
    Vec3 u = vec3_add(flat->origin, flat->edge_u), v = vec3_add(flat->origin, flat->edge_v);
    Vec3 corners[6] = {flat->origin, u, v, u, vec3_add(u, flat->edge_v), v};
    for (int i = 0; i < (flat->is_triangle ? 3 : 6); i++) {
        unsigned char bytes[24], *at = bytes;
        Vec3 vertex[2] = {corners[i], normals[i % 3]};
        for (int k = 0; k < (with_normals ? 6 : 3); k++)
            at = file_put_float(at, vec3_component(vertex[k / 3], k % 3));
        fwrite(bytes, 1, (size_t)(at - bytes), stream);
    }
}

static bool write_ply(const Scene *scene, size_t material, size_t triangles, bool with_normals, const char *path,
                      Error *error)
{
    FileWriter writer;
    if (!file_write_begin(&writer, path, error))
        return false;
    fprintf(
        writer.stream,
        "ply\nformat binary_little_endian 1.0\nelement vertex %zu\nproperty float x\nproperty float y\nproperty float z\n%s"
        "element face %zu\nproperty list uchar int vertex_indices\nend_header\n",
        3 * triangles, with_normals ? "property float nx\nproperty float ny\nproperty float nz\n" : "", triangles);
    for (size_t i = 0; i < scene->flat_count; i++)
        if (scene->flats[i].material == material)
            write_flat(scene, &scene->flats[i], with_normals, writer.stream);
    for (size_t i = 0; i < 3 * triangles; i++) {
        unsigned char bytes[5] = {3}, *at = bytes + (i % 3 == 0);
        at = file_put_int(at, (uint32_t)i);
        fwrite(bytes, 1, (size_t)(at - bytes), writer.stream);
    }
    return file_write_end(&writer, true, error);
}

// Letters and digits of ASCII stay: it becomes part of a file's name, and of words in quotes.
static void make_plain(char *name)
{
    for (; *name; name++)
        if (!isalnum((unsigned char)*name) && !strchr("-_.", *name))
            *name = '_';
}

static const Light *lamp_of(const Scene *scene, size_t material)
{
    for (size_t i = 0; i < scene->light_count; i++) {
        uint32_t at = scene->lights[i].primitive;
        if (at != NO_PRIMITIVE &&
            material ==
                (at < scene->flat_count ? scene->flats[at].material : scene->spheres[at - scene->flat_count].material))
            return &scene->lights[i];
    }
    return NULL;
}

static bool write_material(const Export *e, size_t number, const char *path)
{
    const Scene *scene = e->scene;
    const Material *material = &scene->materials[number];
    const Light *lamp = lamp_of(scene, number);
    char name[100], file[4096];
    snprintf(name, sizeof name, "%zu_%s", number + 1, material->name);
    make_plain(name);
    if (!lamp && !declare(e, material, name))
        return false;
    size_t triangles = 0;
    bool has_normals = false; // interpolated ones, which count on mirrors and glass
    for (size_t i = 0; i < scene->flat_count; i++)
        if (scene->flats[i].material == number) {
            triangles += scene->flats[i].is_triangle ? 1 : 2;
            has_normals |= scene->flats[i].normals && !material_is_rough(material);
        }
    if (triangles > 0) {
        int stem = (int)(strlen(path) - strlen(file_ending(path)));
        const char *slash = strrchr(path, '/');
        size_t folder = slash ? (size_t)(slash + 1 - path) : 0;
        snprintf(file, sizeof file, "%.*s_%s.ply", stem, path, name);
        make_plain(file + folder);
        if (!write_ply(scene, number, triangles, has_normals, file, e->error))
            return false;
        e->format->mesh(e, file + folder, has_normals, name, lamp);
    }
    for (size_t i = 0; i < scene->sphere_count; i++)
        if (scene->spheres[i].material == number)
            e->format->sphere(e, &scene->spheres[i], name, lamp);
    return true;
}

bool export_write(const Scene *scene, const RenderSettings *settings, const char *path, ExportNote note, Error *error)
{
    const ExportFormat *format = export_format(path, error);
    FileWriter writer;
    if (!format || !file_write_begin(&writer, path, error))
        return false;
    Export e = {scene, writer.stream, format, note, error};
    format->begin(&e, settings);
    bool ok = true;
    for (size_t i = 0; i < scene->material_count && ok; i++)
        ok = write_material(&e, i, path);
    for (size_t i = 0; i < scene->light_count && ok; i++)
        if (scene->lights[i].primitive == NO_PRIMITIVE)
            write_light(&e, &scene->lights[i]);
    fputs(format->end, writer.stream);
    return file_write_end(&writer, ok, error);
}
