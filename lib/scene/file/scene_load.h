// Reading scenes from memory, for tests.
#ifndef PHOTONLAB_SCENE_SCENE_LOAD_H
#define PHOTONLAB_SCENE_SCENE_LOAD_H

#include "scene/scene.h"

// scene_load from memory. `file` names the text in messages; `folder` NULL refuses meshes.
Scene *scene_load_text(const char *text, size_t size, const char *file, const char *folder, Error *error);

#endif
