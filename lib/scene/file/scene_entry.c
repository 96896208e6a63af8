#include "scene/file/scene_section.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

bool scene_fault(const SceneEntry *entry, const char *key, const char *format, ...)
{
    const SceneValue *value = key ? scene_value(entry, key) : NULL;
    ScenePlace at = value ? value->place : entry->place;
    char what[700];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    return error_set(entry->file->error, "%s:%u:%u: %s", entry->file->name, (unsigned)at.line, (unsigned)at.column,
                     what);
}

bool scene_out_of_memory(const SceneFile *file)
{
    return error_set(file->error, "%s: not enough memory", file->name);
}

SceneValue *scene_value(const SceneEntry *entry, const char *key)
{
    for (size_t i = 0; i < entry->value_count; i++) {
        SceneValue *value = &entry->file->values[entry->first_value + i];
        if (strcmp(value->key->name, key) == 0)
            return value;
    }
    return NULL;
}

bool scene_check_use(const SceneEntry *entry)
{
    if (entry->without_row)
        return scene_fault(entry, NULL, "the program asks %s for '%s', which is no row of its keys", entry->type->name,
                           entry->without_row);
    for (size_t i = 0; i < entry->value_count; i++) {
        const SceneValue *value = &entry->file->values[entry->first_value + i];
        if (value->given && !value->asked && value->key->kind != KEY_TYPE)
            return scene_fault(entry, value->key->name, "'%s' is a row of %s, but the program does not use it",
                               value->key->name, entry->type->name);
    }
    return true;
}

static SceneValue ask(SceneEntry *entry, const char *key)
{
    SceneValue *value = scene_value(entry, key);
    if (!value) {
        entry->without_row = key;
        return (SceneValue){.given = false};
    }
    value->asked = true;
    return *value;
}

bool scene_given(SceneEntry *entry, const char *key)
{
    return ask(entry, key).given;
}

const char *scene_word(SceneEntry *entry, const char *key)
{
    return ask(entry, key).word;
}

float scene_number(SceneEntry *entry, const char *key)
{
    return (float)ask(entry, key).number[0];
}

long scene_whole(SceneEntry *entry, const char *key)
{
    return (long)ask(entry, key).number[0];
}

Vec3 scene_three(SceneEntry *entry, const char *key)
{
    SceneValue value = ask(entry, key);
    return vec3((float)value.number[0], (float)value.number[1], (float)value.number[2]);
}

Colour scene_colour(SceneEntry *entry, const char *key)
{
    Vec3 three = scene_three(entry, key);
    return colour(three.x, three.y, three.z);
}
