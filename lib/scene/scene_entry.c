#include "scene/scene_entry.h"

#include "base/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static bool fault(const SceneSource *source, ScenePlace place, const char *format, va_list arguments)
{
    char what[700];
    vsnprintf(what, sizeof what, format, arguments);
    text_make_printable(what);
    return error_set(source->error, "%s:%u:%u: %s", source->file, (unsigned)place.line, (unsigned)place.column, what);
}

bool scene_fault_at(const SceneSource *source, ScenePlace place, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fault(source, place, format, arguments);
    va_end(arguments);
    return false;
}

// `key` may end in [0], [1] or [2].
static SceneValue *find_value(const SceneEntry *entry, const char *key, size_t length)
{
    for (size_t i = 0; i < entry->value_count; i++) {
        const char *name = entry->values[i].key->name;
        if (strncmp(name, key, length) == 0 && name[length] == '\0')
            return &entry->values[i];
    }
    return NULL;
}

bool scene_fault(const SceneEntry *entry, const char *key, const char *format, ...)
{
    size_t length = key ? strcspn(key, "[") : 0;
    const SceneValue *value = key ? find_value(entry, key, length) : NULL;
    ScenePlace place = entry->place;
    if (value && value->given)
        place = key[length] ? value->part[key[length + 1] - '0'] : value->place;
    va_list arguments;
    va_start(arguments, format);
    fault(entry->source, place, format, arguments);
    va_end(arguments);
    return false;
}

bool scene_memory_fault(const SceneEntry *entry)
{
    return error_set(entry->source->error, "%s: not enough memory", entry->source->file);
}

// A value of nothing for a key without a row; scene_check_use tells.
static const SceneValue *ask(SceneEntry *entry, const char *key)
{
    static const SceneValue nothing;
    SceneValue *value = find_value(entry, key, strlen(key));
    if (!value) {
        entry->without_row = key;
        return &nothing;
    }
    value->asked = true;
    return value;
}

bool scene_check_use(const SceneEntry *entry)
{
    if (entry->without_row)
        return scene_fault(entry, NULL, "the program asks %s for '%s', which is no row of its keys", entry->type->name,
                           entry->without_row);
    for (size_t i = 0; i < entry->value_count; i++) {
        const SceneValue *value = &entry->values[i];
        if (value->given && !value->asked && value->key->kind != KEY_TYPE)
            return scene_fault(entry, value->key->name, "'%s' is a row of %s, but the program does not use it",
                               value->key->name, entry->type->name);
    }
    return true;
}

bool scene_given(SceneEntry *entry, const char *key)
{
    return ask(entry, key)->given;
}

float scene_number(SceneEntry *entry, const char *key)
{
    return (float)ask(entry, key)->number[0];
}

long scene_whole(SceneEntry *entry, const char *key)
{
    return (long)ask(entry, key)->number[0];
}

Vec3 scene_three(SceneEntry *entry, const char *key)
{
    const double *number = ask(entry, key)->number;
    return vec3((float)number[0], (float)number[1], (float)number[2]);
}

Colour scene_colour(SceneEntry *entry, const char *key)
{
    const double *number = ask(entry, key)->number;
    return colour((float)number[0], (float)number[1], (float)number[2]);
}

const char *scene_word(SceneEntry *entry, const char *key)
{
    return ask(entry, key)->word;
}
