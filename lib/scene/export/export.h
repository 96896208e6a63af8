// A scene as other renderers read it: the same camera, surfaces and lamps, so that a picture can be checked from outside. Meshes lie
// beside the file, a PLY for each material.
#ifndef PHOTONLAB_SCENE_EXPORT_H
#define PHOTONLAB_SCENE_EXPORT_H

#include "scene/scene.h"

#include <stdio.h>

// Is given, in words, what the other renderer cannot do or does otherwise.
typedef struct {
    void (*take)(void *user, const char *words);
    void *user;
} ExportNotes;

// What a format's functions are handed.
typedef struct {
    const Scene *scene;
    FILE *stream;
    const char *renderer;
    ExportNotes notes;
    Error *error;
} Export;

// A renderer's language. Its functions are called from top to bottom.
typedef struct {
    const char *ending, *renderer;
    void (*begin)(const Export *e, const RenderSettings *settings);
    // Declares one that does not shine; false, with the error, when there is no way to say it.
    bool (*material)(const Export *e, const Material *material, const char *name);
    // Shapes of that material. Where it shines, `lamp` is not NULL and the material was not declared.
    void (*mesh)(const Export *e, const char *file, bool has_normals, const char *name, const Light *lamp);
    void (*sphere)(const Export *e, const Sphere *sphere, const char *name, const Light *lamp);
    void (*light)(const Export *e, const Light *light); // one without a surface
    void (*end)(const Export *e);
} ExportFormat;

#define EXPORT_FORMAT(name) extern const ExportFormat export_##name;
#include "scene/export/formats.def"
#undef EXPORT_FORMAT

// True if export_write knows the path's ending; otherwise an error that names those it knows.
bool export_path_is_known(const char *path, Error *error);

// Writes the scene in the format of the path's ending: .xml or .pbrt. False, with the error, when a file cannot be written or a
// material has no counterpart; then the file is not there, though meshes may be.
bool export_write(const Scene *scene, const RenderSettings *settings, const char *path, ExportNotes notes,
                  Error *error);

// ---- for the formats ----

void export_note(const Export *e, const char *format, ...);

// A glossy material as others have it, a mixture of Lambert and a rough mirror: that much of the latter, …
typedef struct {
    float share;
    Colour diffuse, specular; // their reflectances, 0…1
    float roughness; // … whose microfacets (Beckmann) are as wide as the lobe about the mirror direction: α = 1/√(2n)
} ExportGlossy;
ExportGlossy export_glossy(const Export *e, const Material *material);

// False, with the error: the material reflects by a rule of its own.
bool export_is_plain(const Export *e, const Material *material);

// W/sr of a point or spot light.
Colour export_intensity(const Light *light);

#endif
