// Reads scene text by libyaml against the schema, for what libcyaml does not say: where a value stands.
// libcyaml 1.3 also takes "0.35m" for 0.35 and "1e6" for 1, gives the place of a syntax error not at all and
// that of an unknown key wrongly.
#ifndef PHOTONLAB_SCENE_SCENE_LOCATE_H
#define PHOTONLAB_SCENE_SCENE_LOCATE_H

#include "base/error.h"
#include "scene/file/scene_schema.h"

#include <stddef.h>

// Is the text YAML that fits the schema: known keys only, each once and of its type, all mandatory ones,
// numbers finite? If not, the error is "file:line:column: what is wrong; what was expected". Stops at the
// first fault, so that neither deep nesting nor aliases cost anything.
bool scene_check_text(const char *text, size_t size, const char *file, Error *error);

// Line and column (from 1) of a value by its path, such as "lights[2].radius", in text that passed
// scene_check_text. Where there is no such value, those of what it would stand in.
void scene_locate(const char *text, size_t size, const char *path, size_t *line, size_t *column);

#endif
