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

// `of_type`: the row is its type's, not one that all types have.
static bool missing_fault(const SceneEntry *entry, const char *path, const char *key, bool of_type)
{
    char keys[400] = "";
    if (!of_type)
        return scene_fault_at(entry->source, entry->place, "%s has no '%s'; expected this key", path, key);
    list_keys(keys, sizeof keys, entry->type->keys, true);
    return scene_fault_at(entry->source, entry->place, "this %s has no '%s'; expected the keys: %s",
                          entry->type->called, key, keys);
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

// Moves the value of a row out of `read`, if it is there.
static void take_value(const SceneKey *key, SceneValue *read, size_t count, SceneValue *value)
{
    for (size_t i = 0; i < count; i++)
        if (read[i].given && strcmp(read[i].key->name, key->name) == 0) {
            *value = read[i];
            read[i].given = false;
            read[i].word = NULL;
        }
    value->key = key;
}

bool scene_complete_entry(const SceneSection *section, const char *path, SceneValue *read, size_t count,
                          SceneEntry *entry)
{
    entry->type = section->most ? NULL : section->type_at(0);
    for (size_t i = 0; i < count; i++)
        if (read[i].key->kind == KEY_TYPE) {
            entry->type_number = (size_t)read[i].number[0];
            entry->type = section->type_at(entry->type_number);
        }
    if (!entry->type)
        return missing_fault(entry, path, "type", false);
    size_t common = count_keys(section->keys), rows = common + count_keys(entry->type->keys);
    entry->values = calloc(rows, sizeof *entry->values);
    if (!entry->values)
        return scene_memory_fault(entry);
    while (entry->value_count < rows) {
        size_t i = entry->value_count++;
        SceneValue *value = &entry->values[i];
        take_value(i < common ? &section->keys[i] : &entry->type->keys[i - common], read, count, value);
        if (!value->given && value->key->otherwise == KEY_REQUIRED)
            return missing_fault(entry, path, value->key->name, i >= common && section->most);
        if (!(value->given ? check_value(entry, path, value) : set_otherwise(entry, value)))
            return false;
    }
    for (size_t i = 0; i < count; i++)
        if (read[i].given)
            return foreign_fault(entry, &read[i]);
    return true;
}
