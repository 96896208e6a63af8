// What a scene file says, as it was read, and its sections: camera, render, materials, lights, shapes. Their table is the
// whole format: what may stand in each, and what is made of it.
#pragma once

#include "scene/limits.h"
#include "scene/scene.h"
#include "scene/scene_key.h"

typedef struct {
    uint32_t line, column; // from 1
} ScenePlace;

// The value of a key.
typedef struct {
    const SceneKey *key;
    bool given; // by the file; otherwise the value that holds where it leaves the key out
    bool asked; // for by a build function
    ScenePlace place, part[3];
    double number[3]; // of KEY_TYPE: the type's number
    char *word;
} SceneValue;

// A file, and the scene that is made of it.
typedef struct {
    const char *name; // for messages
    Error *error;
    SceneEntry *entries;
    SceneValue *values;
    size_t entry_count, entry_capacity, value_count, value_capacity;
    const char *folder; // where meshes are looked for, with a slash at its end; NULL: none are read
    Scene *scene;       // a light's sphere counts from 0 in it until all flats are known
    size_t flat_capacity, normal_capacity;
} SceneFile;

struct SceneEntry {
    SceneFile *file;
    const struct SceneSection *section;
    const SceneType *type;
    size_t type_number; // in its section
    ScenePlace place;
    size_t first_value, value_count; // in file->values
    const char *without_row;         // a key that was asked for and is none
};

// NULL: it has none for this key.
SceneValue *scene_value(const SceneEntry *entry, const char *key);

// A fault at a place that is no key's: "file:line:column: …". Always false.
#define scene_fault_at(of, at, ...) scene_fault(&(SceneEntry){.file = (of), .place = (at)}, NULL, __VA_ARGS__)
bool scene_out_of_memory(const SceneFile *file); // "file: not enough memory", false

// Was every given key asked for, and no other? If not, the program lacks a row, or the code that uses one.
bool scene_check_use(const SceneEntry *entry);

#define NO_MATERIAL UINT32_MAX

// The count of flats or spheres grows. False when memory is short.
bool scene_add_flat(SceneEntry *entry, Flat flat);
bool scene_add_sphere(SceneEntry *entry, Sphere sphere);

// May these be sides of a flat? If not, says why at `key`.
bool scene_check_edges(const SceneEntry *entry, const char *key, Vec3 edge_u, Vec3 edge_v);

// Name number i of the file's materials, NULL past the last: a TextNameAt.
const char *scene_material_name(const void *file, size_t i);

// A mesh's triangles; `material` for faces without usemtl, NO_MATERIAL when there is none.
bool scene_build_mesh(SceneEntry *entry, uint32_t material);

// Turns by an angle in degrees about axis 0, 1 or 2, counter-clockwise for who looks against the axis.
Vec3 scene_rotate(Vec3 p, int axis, float degrees);

typedef struct SceneSection {
    const char *name, *meaning;
    size_t most;                           // entries of a list; 0: the section is a single entry
    bool required;                         // this entry, or at least one of the list
    const SceneKey *keys;                  // that entries of every type have
    const SceneType *type;                 // the only one; NULL: the entry's `type:` says which
    const SceneType *(*type_at)(size_t i); // then: type number i, NULL past the last
    // Makes an entry a part of the scene, and refuses what only shows in combination.
    bool (*build)(SceneEntry *entry);
} SceneSection;

enum { SCENE_SECTIONS = 5 };
extern const SceneSection *const scene_sections[SCENE_SECTIONS]; // in the order in which they are built
extern const SceneSection camera_section, render_section, material_section, light_section, shape_section;

const SceneType *scene_type_at(const SceneSection *section, size_t i);

// Row number i of a section, those of every type and then each type's own; NULL past the last.
const SceneKey *scene_key_at(const SceneSection *section, size_t i);

// Is the text YAML, with known keys only, each once and with a value of its kind and range, and none missing? The error
// is "file:line:column: what is wrong; what was expected". Reading stops at the first fault, so that neither deep
// nesting nor aliases cost anything. Puts entries and values into the file; the caller frees them, also after a failure.
bool scene_read(const char *text, size_t size, SceneFile *file);
void scene_file_free(SceneFile *file);

// A value behind those of the last entry; NULL when memory is short.
SceneValue *scene_add_value(SceneFile *file, SceneEntry *entry, const SceneKey *key);

// The second half of reading the last entry, when all values that the file gives are there: finds its type, holds the
// values against its rows, and adds what holds where one was left out. `path` names the entry in messages.
bool scene_complete(SceneFile *file, SceneEntry *entry, const char *path);
