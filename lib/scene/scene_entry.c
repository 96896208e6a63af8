#include "scene/scene_entry.h"

#include "base/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static bool fault(const SceneFile *file, ScenePlace place, const char *format, va_list arguments)
{
    char what[700];
    vsnprintf(what, sizeof what, format, arguments);
    text_make_printable(what);
    return error_set(file->error, "%s:%u:%u: %s", file->name, (unsigned)place.line, (unsigned)place.column, what);
}

bool scene_fault_at(const SceneFile *file, ScenePlace place, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fault(file, place, format, arguments);
    va_end(arguments);
    return false;
}

bool scene_fault(const SceneEntry *entry, const char *key, const char *format, ...)
{
    const SceneValue *value = key ? scene_value(entry, key) : NULL;
    ScenePlace place = entry->place;
    if (value)
        place = strchr(key, '[') ? value->part[strchr(key, '[')[1] - '0'] : value->place;
    va_list arguments;
    va_start(arguments, format);
    fault(entry->file, place, format, arguments);
    va_end(arguments);
    return false;
}

bool scene_memory_fault(const SceneEntry *entry)
{
    return error_set(entry->file->error, "%s: not enough memory", entry->file->name);
}

const SceneKey *scene_row(const SceneEntry *entry, const char *key)
{
    const SceneKey *const tables[] = {entry->common, entry->type->keys};
    for (int t = 0; t < 2; t++)
        for (const SceneKey *row = tables[t]; row->name; row++)
            if (strcmp(row->name, key) == 0)
                return row;
    return NULL;
}

SceneValue *scene_value(const SceneEntry *entry, const char *key)
{
    size_t length = strcspn(key, "[");
    for (size_t i = 0; i < entry->value_count; i++) {
        SceneValue *value = &entry->file->values[entry->first_value + i];
        if (strncmp(value->key->name, key, length) == 0 && value->key->name[length] == '\0')
            return value;
    }
    return NULL;
}

// What the file gives; NULL, and the words of what holds otherwise, where it leaves the key out.
static const SceneValue *ask(SceneEntry *entry, const char *key, const char **otherwise)
{
    SceneValue *value = scene_value(entry, key);
    const SceneKey *row = scene_row(entry, key);
    *otherwise = row && row->otherwise ? row->otherwise : "";
    if (value)
        value->asked = true;
    if (!row)
        entry->without_row = key;
    return value;
}

bool scene_check_use(const SceneEntry *entry)
{
    if (entry->without_row)
        return scene_fault(entry, NULL, "the program asks %s for '%s', which is no row of its keys", entry->type->name,
                           entry->without_row);
    for (size_t i = 0; i < entry->value_count; i++) {
        const SceneValue *value = &entry->file->values[entry->first_value + i];
        if (!value->asked && value->key->kind != KEY_TYPE)
            return scene_fault(entry, value->key->name, "'%s' is a row of %s, but the program does not use it",
                               value->key->name, entry->type->name);
    }
    return true;
}

bool scene_given(SceneEntry *entry, const char *key)
{
    const char *otherwise;
    return ask(entry, key, &otherwise) != NULL;
}

const char *scene_word(SceneEntry *entry, const char *key)
{
    const char *otherwise;
    const SceneValue *value = ask(entry, key, &otherwise);
    return value ? value->word : otherwise[0] ? otherwise : NULL;
}

static void ask_numbers(SceneEntry *entry, const char *key, double number[3])
{
    const char *at;
    const SceneValue *value = ask(entry, key, &at);
    const char *end = at + strlen(at);
    for (int i = 0; i < 3; i++) {
        number[i] = value ? value->number[i] : 0.0;
        at += strspn(at, "[, ");
        if (!value)
            text_number(&at, end, &number[i]);
    }
}

float scene_number(SceneEntry *entry, const char *key)
{
    return scene_three(entry, key).x;
}

long scene_whole(SceneEntry *entry, const char *key)
{
    double number[3];
    ask_numbers(entry, key, number);
    return (long)number[0];
}

Vec3 scene_three(SceneEntry *entry, const char *key)
{
    double number[3];
    ask_numbers(entry, key, number);
    return vec3((float)number[0], (float)number[1], (float)number[2]);
}

Colour scene_colour(SceneEntry *entry, const char *key)
{
    Vec3 three = scene_three(entry, key);
    return colour(three.x, three.y, three.z);
}
