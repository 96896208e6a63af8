// What a scene file says, as it was read: filled by scene/file, asked by the build functions (scene_key.h).
#ifndef PHOTONLAB_SCENE_SCENE_ENTRY_H
#define PHOTONLAB_SCENE_SCENE_ENTRY_H

#include "base/error.h"
#include "scene/scene_key.h"

#include <stddef.h>
#include <stdint.h>

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
    int count;        // of numbers that the file gives for the key's range
    char *word;
} SceneValue;

typedef struct {
    const char *name; // for messages
    Error *error;
    SceneEntry *entries;
    SceneValue *values;
    size_t entry_count, entry_capacity, value_count, value_capacity;
} SceneFile;

struct SceneEntry {
    const SceneFile *file;
    int section;
    const SceneKey *common; // rows that the section has for every type
    const SceneType *type;
    size_t type_number; // in its section
    ScenePlace place;
    size_t first_value, value_count; // in file->values
    const char *without_row;         // a key that was asked for and is none
};

// NULL: it has none for this key.
SceneValue *scene_value(const SceneEntry *entry, const char *key);

// Writes "file:line:column: …". Always false.
bool scene_fault_at(const SceneFile *file, ScenePlace place, const char *format, ...) PRINTF_LIKE(3, 4);
bool scene_out_of_memory(const SceneFile *file); // "file: not enough memory", false

// Was every given key asked for, and no other? If not, the program lacks a row, or the code that uses one.
bool scene_check_use(const SceneEntry *entry);

#endif
