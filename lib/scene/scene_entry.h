// An entry of the scene file as it was read: filled by scene/file, asked by the build functions (scene_key.h).
#ifndef PHOTONLAB_SCENE_SCENE_ENTRY_H
#define PHOTONLAB_SCENE_SCENE_ENTRY_H

#include "base/error.h"
#include "scene/scene_key.h"

#include <stddef.h>
#include <stdint.h>

typedef struct {
    uint32_t line, column; // from 1
} ScenePlace;

typedef struct {
    const char *file;
    Error *error;
} SceneSource;

typedef struct {
    const SceneKey *key;
    bool given; // by the file
    bool asked; // for by a build function
    ScenePlace place, part[3];
    double number[3];
    char *word; // owned by who fills the entry
} SceneValue;

struct SceneEntry {
    const SceneSource *source;
    const SceneType *type;
    size_t type_number; // of its section
    ScenePlace place;
    SceneValue *values; // one for each row of its type
    size_t value_count;
    const char *without_row; // a key that was asked for and is none
};

// Writes "file:line:column: …". Always false.
bool scene_fault_at(const SceneSource *source, ScenePlace place, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 3, 4)))
#endif
    ;

// Was every given key asked for, and no other? If not, the program lacks a row, or the code that uses one.
bool scene_check_use(const SceneEntry *entry);

#endif
