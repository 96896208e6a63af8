// A walk along the events of a scene file's text, and its faults. `path` names what is read: "shapes[0].centre".
#pragma once

#include "scene/file/scene_section.h"

#include <yaml.h>

#define WALK_PATH 128 // characters of a path

typedef struct {
    yaml_parser_t parser;
    yaml_event_t event; // at hand
    const char *text;
    size_t size;
    SceneFile *file;
} SceneWalk;

// The next event is at hand. False, with the fault told, where the text is no YAML.
bool walk_next(SceneWalk *walk);

// Where the event at hand begins, and the word that it is; NULL: it is none.
ScenePlace walk_place(const SceneWalk *walk);
const char *walk_scalar(const SceneWalk *walk);

// What is at hand is something else than what is `expected`. Always false.
bool walk_kind_fault(const SceneWalk *walk, const char *path, const char *expected);

// Reads the value at hand by its row; that of KEY_TYPE is the number of the section's type.
bool walk_read_value(SceneWalk *walk, const SceneSection *section, const char *path, SceneValue *value);
