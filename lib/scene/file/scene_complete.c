// What can be said of an entry without looking at others: its type's keys, and the range of each value.
#include "scene/file/scene_read.h"

#include "base/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool in_range(const SceneRange *range, double value)
{
    return range->open ? value > range->low && value < range->high : value >= range->low && value <= range->high;
}

static bool check_numbers(const SceneEntry *entry, const SceneValue *value, int count)
{
    const SceneKey *key = value->key;
    for (int i = 0; i < count; i++) {
        if (in_range(&key->range, value->number[i]))
            continue;
        char expected[100];
        scene_range_words(&key->range, expected, sizeof expected);
        return scene_fault_at(entry->source, count == 3 ? value->part[i] : value->place, "%s is %.*g; expected %s",
                              key->name, key->kind == KEY_WHOLE ? 10 : 6, value->number[i], expected);
    }
    return true;
}

static bool check_value(const SceneEntry *entry, const char *path, const SceneValue *value)
{
    switch (value->key->kind) {
    case KEY_NUMBER:
    case KEY_WHOLE:
        return check_numbers(entry, value, 1);
    case KEY_THREE:
    case KEY_COLOUR:
        return check_numbers(entry, value, 3);
    case KEY_WORD:
        return (double)strlen(value->word) <= value->key->range.high ||
               scene_fault_at(entry->source, value->place, "%s.%s is %zu characters long; expected at most %.0f", path,
                              value->key->name, strlen(value->word), value->key->range.high);
    case KEY_TYPE:
        return true;
    }
    return false;
}

// The value that a row gives to a key which is left out.
static bool set_otherwise(const SceneEntry *entry, SceneValue *value)
{
    const char *at = value->key->otherwise, *end = at + strlen(at);
    if (value->key->kind == KEY_WORD && at < end)
        return (value->word = strdup(at)) || scene_memory_fault(entry);
    for (int i = 0; i < 3 && at < end; i++) {
        at += strspn(at, "[, ");
        text_number(&at, end, &value->number[i]);
    }
    return true;
}

// Adds the names of the keys that are required, or of those that are not.
static void list_keys(char *text, size_t size, const SceneKey *keys, bool required)
{
    size_t used = strlen(text);
    for (; keys->name && used < size; keys++)
        if (!keys->otherwise == required)
            used += (size_t)snprintf(text + used, size - used, "%s%s", used ? " " : "", keys->name);
}

static bool missing_fault(const SceneEntry *entry, const char *path, const SceneValue *value, bool of_type)
{
    char keys[400] = "";
    if (!of_type)
        return scene_fault_at(entry->source, entry->place, "%s has no '%s'; expected this key", path, value->key->name);
    list_keys(keys, sizeof keys, entry->type->keys, true);
    return scene_fault_at(entry->source, entry->place, "this %s has no '%s'; expected the keys: %s",
                          entry->type->called, value->key->name, keys);
}

static bool foreign_fault(const SceneEntry *entry, const SceneValue *value)
{
    char keys[400] = "";
    list_keys(keys, sizeof keys, entry->type->keys, true);
    list_keys(keys, sizeof keys, entry->type->keys, false);
    return scene_fault_at(entry->source, value->place, "a %s has no '%s'; its keys are: %s", entry->type->called,
                          value->key->name, keys);
}

static size_t count_keys(const SceneKey *keys)
{
    size_t count = 0;
    while (keys[count].name)
        count++;
    return count;
}

static void take_values(const SceneKey *keys, SceneValue *read, size_t read_count, SceneEntry *entry)
{
    for (; keys->name; keys++) {
        SceneValue *value = &entry->values[entry->value_count++];
        for (size_t i = 0; i < read_count; i++)
            if (read[i].given && strcmp(read[i].key->name, keys->name) == 0) {
                *value = read[i];
                read[i] = (SceneValue){.given = false};
            }
        value->key = keys;
    }
}

// A section without types has one.
static bool set_type(const SceneSection *section, const char *path, const SceneValue *read, size_t read_count,
                     SceneEntry *entry)
{
    bool has_types = false;
    for (const SceneKey *key = section->keys; key->name; key++)
        has_types = has_types || key->kind == KEY_TYPE;
    for (size_t i = 0; i < read_count; i++)
        if (read[i].given && read[i].key->kind == KEY_TYPE) {
            entry->type_number = (size_t)read[i].number[0];
            has_types = false;
        }
    entry->type = section->type_at(entry->type_number);
    return !has_types || scene_fault_at(entry->source, entry->place, "%s has no 'type'; expected this key", path);
}

bool scene_complete_entry(const SceneSection *section, const char *path, SceneValue *read, size_t read_count,
                          SceneEntry *entry)
{
    if (!set_type(section, path, read, read_count, entry))
        return false;
    size_t common = count_keys(section->keys);
    entry->values = calloc(common + count_keys(entry->type->keys), sizeof *entry->values);
    if (!entry->values)
        return scene_memory_fault(entry);
    take_values(section->keys, read, read_count, entry);
    take_values(entry->type->keys, read, read_count, entry);
    for (size_t i = 0; i < read_count; i++)
        if (read[i].given)
            return foreign_fault(entry, &read[i]);
    for (size_t i = 0; i < entry->value_count; i++) {
        SceneValue *value = &entry->values[i];
        if (!value->given && value->key->otherwise == KEY_REQUIRED)
            return missing_fault(entry, path, value, i >= common && entry->type->called);
        if (!(value->given ? check_value(entry, path, value) : set_otherwise(entry, value)))
            return false;
    }
    return true;
}
