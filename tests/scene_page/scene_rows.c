#include "scene_page/scene_rows.h"

#include <stdio.h>
#include <string.h>

#define FOLDER "scenes/" // where examples find their meshes

// A scene around one entry: what it lacks to be complete. Gives the loader's message, "" when it loads.
static Error load_example(const SceneSection *section, const char *entry)
{
    char text[4000];
    int used = 0;
    const struct {
        const SceneSection *section;
        const char *text;
    } parts[] = {
        {&camera_section, "camera: {position: [0, 0, 4], target: [0, 0, 0], vertical_fov: 40}"},
        {&light_section, "lights:\n- {type: point, position: [0, 0, 0], power: [1, 1, 1]}"},
        {&material_section, "materials:\n- {name: white, type: mirror}\n- {name: clear, type: mirror}"},
    };
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++)
        if (parts[i].section != section)
            used += snprintf(text + used, sizeof text - (size_t)used, "%s\n", parts[i].text);
    if (section->most)
        used += snprintf(text + used, sizeof text - (size_t)used, "%s:\n- ", section->name);
    used += snprintf(text + used, sizeof text - (size_t)used, "%s\n", entry);
    Error error = {""};
    scene_free(scene_load_text(text, (size_t)used, section->name, FOLDER, &error));
    return error;
}

static bool is_unsound(const SceneType *type, const char *of, const char *what)
{
    fprintf(stderr, "✗ %s %s: %s\n", of, type->name ? type->name : "", what);
    return false;
}

// The example once more, with a key that it does not have. The program may refuse it for what it says, but must have
// looked at it.
static bool row_is_used(const SceneSection *section, const SceneType *type, const SceneKey *key)
{
    char with[1000], named[100];
    snprintf(named, sizeof named, "%s: ", key->name);
    if (strstr(type->example, named))
        return true;
    int before = (int)(strrchr(type->example, '}') - type->example);
    bool has_value = key->otherwise && key->otherwise[0];
    const char *value = has_value                                           ? key->otherwise
                        : key->kind == KEY_THREE || key->kind == KEY_COLOUR ? "[1, 1, 1]"
                        : key->kind == KEY_WORD                             ? "white"
                                                                            : "1";
    snprintf(with, sizeof with, "%.*s, %s%s}", before, type->example, named, value);
    Error error = load_example(section, with);
    return !strstr(error.message, "the program") || is_unsound(type, section->name, error.message);
}

// Behind the last row there must be one without a name, at which its readers end.
static bool table_ends(const SceneKey *keys, const char *name)
{
    if (!keys || !keys[MOST_SCENE_KEYS].name)
        return true;
    fprintf(stderr, "✗ %s: more than %d keys; MOST_SCENE_KEYS in lib/scene/scene_key.h allows no more\n", name,
            MOST_SCENE_KEYS);
    return false;
}

static bool type_is_sound(const SceneSection *section, const SceneType *type)
{
    Error error = load_example(section, type->example);
    if (error.message[0])
        return is_unsound(type, section->name, error.message);
    for (const SceneKey *key = type->keys; key->name; key++)
        if (!row_is_used(section, type, key))
            return false;
    return true;
}

// Rows of one name have one kind, since a value may be read before the type is known.
static bool kinds_agree(const SceneSection *section)
{
    const SceneKey *key, *other;
    for (size_t i = 0; (key = scene_key_at(section, i)); i++)
        for (size_t k = 0; k < i && (other = scene_key_at(section, k)); k++)
            if (strcmp(key->name, other->name) == 0 && key->kind != other->kind) {
                fprintf(stderr, "✗ %s: '%s' is of two kinds\n", section->name, key->name);
                return false;
            }
    return true;
}

bool scene_rows_are_sound(void)
{
    bool sound = true;
    const SceneType *type;
    for (int s = 0; s < SCENE_SECTIONS; s++) {
        sound = table_ends(scene_sections[s]->keys, scene_sections[s]->name) && sound;
        for (size_t i = 0; (type = scene_type_at(scene_sections[s], i)); i++)
            sound = table_ends(type->keys, type->name) && sound;
    }
    for (int s = 0; sound && s < SCENE_SECTIONS; s++) {
        sound = kinds_agree(scene_sections[s]) && sound;
        for (size_t i = 0; (type = scene_type_at(scene_sections[s], i)); i++)
            sound = type_is_sound(scene_sections[s], type) && sound;
    }
    return sound;
}
