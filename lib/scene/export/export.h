// A scene as other renderers read it: the same camera, surfaces and lamps, so that a picture can be checked from outside. Meshes lie
// beside the file, a PLY for each material.
#pragma once

#include "scene/scene.h"

#include <stdio.h>

typedef struct ExportFormat ExportFormat;

// Is told, in words, what the other renderer cannot do or does otherwise; NULL: nobody is.
typedef void (*ExportNote)(const char *words);

// What a format's functions are handed.
typedef struct {
    const Scene *scene;
    FILE *stream;
    const ExportFormat *format;
    ExportNote note;
    Error *error;
} Export;

// A glossy material as others have it, a mixture of Lambert and a rough mirror: that much of the latter, …
typedef struct {
    float share;
    Colour diffuse, specular; // their reflectances, 0…1
    float roughness; // … whose microfacets (Beckmann) are as wide as the lobe about the mirror direction: α = 1/√(2n)
} ExportGlossy;

// A renderer's language. Its functions are called from top to bottom.
struct ExportFormat {
    const char *ending, *renderer, *end; // of its files' names; its name; what stands last in a file
    void (*begin)(const Export *e, const RenderSettings *settings);
    // Declare a material under its name.
    void (*diffuse)(const Export *e, const char *name, Colour reflectance);
    void (*glossy)(const Export *e, const char *name, ExportGlossy glossy);
    void (*mirror)(const Export *e, const char *name, const Material *material);
    void (*glass)(const Export *e, const char *name, const Material *material);
    // Shapes of that material. Where it shines, `lamp` is not NULL and the material was not declared.
    void (*mesh)(const Export *e, const char *file, bool has_normals, const char *name, const Light *lamp);
    void (*sphere)(const Export *e, const Sphere *sphere, const char *name, const Light *lamp);
    // A point or a spot light; its intensity is in W/sr.
    void (*light)(const Export *e, const Light *light, Colour intensity);
};

#define EXPORT_FORMAT(name) extern const ExportFormat export_##name;
#include "scene/export/formats.def"
#undef EXPORT_FORMAT

// The one of the path's ending; NULL, with an error that names those that are known.
const ExportFormat *export_format(const char *path, Error *error);

// Writes the scene in the format of the path's ending: .xml or .pbrt. False, with the error, when a file cannot be written or a
// material has no counterpart; then the file is not there, though meshes may be.
bool export_write(const Scene *scene, const RenderSettings *settings, const char *path, ExportNote note, Error *error);

// What a format tells of what is lost.
void export_note(const Export *e, const char *format, ...);
