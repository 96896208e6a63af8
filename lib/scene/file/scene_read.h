// Reading the text of a scene file by the rows of its keys.
#ifndef PHOTONLAB_SCENE_SCENE_READ_H
#define PHOTONLAB_SCENE_SCENE_READ_H

#include "scene/file/scene_section.h"

// What a file says in one section.
typedef struct {
    ScenePlace place; // of the section; of the scene where it is left out
    bool given;
    SceneEntry *entries;
    size_t count, capacity;
} SceneList;

// Is the text YAML, with known keys only, each once and with a value of its kind and range, and none missing? The error
// is "file:line:column: what is wrong; what was expected". Reading stops at the first fault, so that neither deep
// nesting nor aliases cost anything. The caller frees the lists, also after a failure.
bool scene_read(const char *text, size_t size, const SceneSource *source, SceneList lists[SCENE_SECTIONS]);
void scene_lists_free(SceneList lists[SCENE_SECTIONS]);

// The second half of reading an entry: of the values that were read it makes entry->values, by the rows of its type, with
// what holds for those that were left out. Takes out of `read` what it keeps. `path` names the entry in messages.
bool scene_complete_entry(const SceneSection *section, const char *path, SceneValue *read, size_t count,
                          SceneEntry *entry);

#endif
