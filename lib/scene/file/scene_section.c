#include "scene/file/scene_section.h"

#include <stdio.h>
#include <string.h>

const SceneSection *const scene_sections[SCENE_SECTIONS] = {&camera_section, &render_section, &material_section,
                                                            &light_section, &shape_section};

static size_t add_keys(const SceneKey *from, const SceneKey *keys[MOST_SECTION_KEYS], size_t count)
{
    for (; from->name; from++) {
        size_t i = 0;
        while (i < count && strcmp(keys[i]->name, from->name) != 0)
            i++;
        if (i == count && count < MOST_SECTION_KEYS)
            keys[count++] = from;
    }
    return count;
}

size_t scene_section_keys(const SceneSection *section, const SceneKey *keys[MOST_SECTION_KEYS])
{
    const SceneType *type;
    size_t count = add_keys(section->keys, keys, 0);
    for (size_t i = 0; (type = section->type_at(i)); i++)
        count = add_keys(type->keys, keys, count);
    return count;
}

void scene_range_words(const SceneRange *range, char *text, size_t size)
{
    const char *unit = range->unit ? range->unit : "";
    if (range->expected)
        snprintf(text, size, "%s", range->expected);
    else
        snprintf(text, size, "%.10g to %.10g%s%s", range->low, range->high, unit[0] ? " " : "", unit);
}
