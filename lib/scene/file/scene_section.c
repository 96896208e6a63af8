#include "scene/file/scene_section.h"

#include "base/array.h"
#include "base/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const SceneSection *const scene_sections[SCENE_SECTIONS] = {&camera_section, &render_section, &material_section,
                                                            &light_section, &shape_section};

const SceneType *scene_type_at(const SceneSection *section, size_t i)
{
    return section->type_at ? section->type_at(i) : i == 0 ? section->type : NULL;
}

const SceneKey *scene_key_at(const SceneSection *section, size_t i)
{
    const SceneType *type;
    const SceneKey *key = section->keys;
    for (size_t t = 0; key; key = (type = scene_type_at(section, t++)) ? type->keys : NULL)
        for (; key->name; key++)
            if (i-- == 0)
                return key;
    return NULL;
}

SceneValue *scene_add_value(SceneFile *file, SceneEntry *entry, const SceneKey *key)
{
    if (!array_reserve(&file->values, file->value_count + 1, &file->value_capacity, sizeof(SceneValue))) {
        scene_out_of_memory(file);
        return NULL;
    }
    SceneValue *value = &file->values[file->value_count++];
    entry->value_count++;
    *value = (SceneValue){.key = key, .place = entry->place};
    return value;
}

// The row of a key; NULL: its type has none.
static const SceneKey *row_of(const SceneEntry *entry, const char *name)
{
    const SceneKey *const tables[] = {entry->section->keys, entry->type->keys};
    for (int t = 0; t < 2; t++)
        for (const SceneKey *row = tables[t]; row->name; row++)
            if (strcmp(row->name, name) == 0)
                return row;
    return NULL;
}

static bool check_range(const SceneEntry *entry, const char *path, const SceneValue *value)
{
    const SceneKey *key = value->key;
    const SceneRange *range = &key->range;
    if (value->word && (double)strlen(value->word) > range->high)
        return scene_fault_at(entry->file, value->place, "%s.%s is %zu characters long; expected at most %.0f", path,
                              key->name, strlen(value->word), range->high);
    int count =
        key->kind == KEY_THREE || key->kind == KEY_COLOUR ? 3 : key->kind == KEY_NUMBER || key->kind == KEY_WHOLE;
    for (int i = 0; i < count; i++) {
        double number = value->number[i];
        if (range->open ? number > range->low && number < range->high : number >= range->low && number <= range->high)
            continue;
        char expected[100];
        snprintf(expected, sizeof expected, "%.10g to %.10g%s%s", range->low, range->high, range->unit ? " " : "",
                 range->unit ? range->unit : "");
        return scene_fault_at(entry->file, value->part[i], "%s is %.*g; expected %s", key->name,
                              key->kind == KEY_WHOLE ? 10 : 6, number, range->expected ? range->expected : expected);
    }
    return true;
}

// The names of the keys that are required, and of the others too.
static TextLine list_keys(const SceneKey *keys, bool others)
{
    TextLine list = {""};
    for (int pass = 0; pass <= others; pass++)
        for (const SceneKey *key = keys; key->name; key++)
            if (!key->otherwise == !pass)
                text_append(list.text, sizeof list.text, "%s%s", list.text[0] ? " " : "", key->name);
    return list;
}

// Adds the values that hold for keys that were left out; a fault for one that is required.
static bool add_others(SceneFile *file, SceneEntry *entry, const SceneKey *keys, const char *path)
{
    for (const SceneKey *key = keys; key->name; key++) {
        if (scene_value(entry, key->name))
            continue;
        if (!key->otherwise && (keys == entry->section->keys || !entry->type->called))
            return scene_fault(entry, NULL, "%s has no '%s'; expected this key", path, key->name);
        if (!key->otherwise)
            return scene_fault(entry, NULL, "this %s has no '%s'; expected the keys: %s", entry->type->called,
                               key->name, list_keys(keys, false).text);
        SceneValue *value = scene_add_value(file, entry, key);
        if (!value)
            return false;
        const char *at = key->otherwise, *end = at + strlen(at);
        if (key->kind == KEY_WORD && *at && !(value->word = strdup(at)))
            return scene_out_of_memory(file);
        for (int i = 0; i < 3; i++) {
            at += strspn(at, "[, ");
            text_number(&at, end, &value->number[i]);
        }
    }
    return true;
}

bool scene_complete(SceneFile *file, SceneEntry *entry, const char *path)
{
    if (!add_others(file, entry, entry->section->keys, path))
        return false;
    const SceneValue *type = scene_value(entry, "type");
    entry->type_number = type ? (size_t)type->number[0] : 0;
    entry->type = scene_type_at(entry->section, entry->type_number);
    for (size_t i = 0; i < entry->value_count; i++) {
        SceneValue *value = &file->values[entry->first_value + i];
        const SceneKey *row = row_of(entry, value->key->name);
        if (!row)
            return scene_fault(entry, value->key->name, "a %s has no '%s'; its keys are: %s", entry->type->called,
                               value->key->name, list_keys(entry->type->keys, true).text);
        value->key = row;
        if (!check_range(entry, path, value))
            return false;
    }
    return add_others(file, entry, entry->type->keys, path);
}

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
