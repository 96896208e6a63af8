// A walk along the events of a scene file's text, and its faults.
#ifndef PHOTONLAB_SCENE_SCENE_WALK_H
#define PHOTONLAB_SCENE_SCENE_WALK_H

#include "scene/file/scene_section.h"

#include <yaml.h>

// Where the walk is serves for messages.
typedef struct {
    yaml_parser_t parser;
    yaml_event_t event; // at hand
    const char *text;
    size_t size;
    SceneFile *file;
    const SceneSection *section; // NULL: none yet
    int index;                   // of the entry; −1: not in a list
    const char *key;             // whose value is read; NULL: none
    int part;                    // of a value of three; −1: all of it
} SceneWalk;

// The next event is at hand. False, with the fault told, where the text is no YAML.
bool walk_next(SceneWalk *walk);

// Where the event at hand begins.
ScenePlace walk_place(const SceneWalk *walk);

// "shapes[0].centre[1]": what is read, for messages.
typedef struct {
    char text[128];
} WalkPath;
WalkPath walk_path(const SceneWalk *walk);

// What is at hand is something else than what is `expected`. Always false.
bool walk_kind_fault(const SceneWalk *walk, const char *expected);

// Reads the value at hand by its row; that of KEY_TYPE is the number of the type.
bool walk_read_value(SceneWalk *walk, SceneValue *value);

#endif
