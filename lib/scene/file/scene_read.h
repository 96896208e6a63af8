// Reading the text of a scene file by the rows of its keys.
#ifndef PHOTONLAB_SCENE_SCENE_READ_H
#define PHOTONLAB_SCENE_SCENE_READ_H

#include "scene/file/scene_section.h"

// Is the text YAML, with known keys only, each once and with a value of its kind and range, and none missing? The error
// is "file:line:column: what is wrong; what was expected". Reading stops at the first fault, so that neither deep
// nesting nor aliases cost anything. Puts entries and values into the file; the caller frees them, also after a failure.
bool scene_read(const char *text, size_t size, SceneFile *file);
void scene_file_free(SceneFile *file);

// The second half of reading an entry, when all its values are there: finds its type, and holds the values against its
// rows. `path` names the entry in messages.
bool scene_check_entry(const SceneSection *section, const char *path, SceneEntry *entry);

#endif
