#include "scene/file/scene_section.h"

const SceneSection *const scene_sections[SCENE_SECTIONS] = {&camera_section, &render_section, &material_section,
                                                            &light_section, &shape_section};

const SceneKey *scene_key_at(const SceneSection *section, size_t i)
{
    const SceneType *type;
    const SceneKey *key = section->keys;
    for (size_t t = 0; key; key = (type = section->type_at(t++)) ? type->keys : NULL)
        for (; key->name; key++)
            if (i-- == 0)
                return key;
    return NULL;
}
