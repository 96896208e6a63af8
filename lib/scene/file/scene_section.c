#include "scene/file/scene_section.h"

#include "base/text.h"

#include <string.h>

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

static bool in_range(const SceneRange *range, double value)
{
    return range->open ? value > range->low && value < range->high : value >= range->low && value <= range->high;
}

static bool check_numbers(const SceneEntry *entry, const SceneValue *value, int count)
{
    const SceneKey *key = value->key;
    const char *unit = key->range.unit;
    for (int i = 0; i < count; i++) {
        if (in_range(&key->range, value->number[i]))
            continue;
        char expected[100] = "";
        if (key->range.expected)
            text_append(expected, sizeof expected, "%s", key->range.expected);
        else
            text_append(expected, sizeof expected, "%.10g to %.10g%s%s", key->range.low, key->range.high,
                        unit ? " " : "", unit ? unit : "");
        return scene_fault_at(entry->file, count == 3 ? value->part[i] : value->place, "%s is %.*g; expected %s",
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
               scene_fault_at(entry->file, value->place, "%s.%s is %zu characters long; expected at most %.0f", path,
                              value->key->name, strlen(value->word), value->key->range.high);
    case KEY_TYPE:
        return true;
    }
    return false;
}

typedef struct {
    char text[400];
} KeyList;

// The names of the keys that are required, and of the others too.
static KeyList list_keys(const SceneKey *keys, bool others)
{
    KeyList list = {""};
    for (int pass = 0; pass <= others; pass++)
        for (const SceneKey *key = keys; key->name; key++)
            if (!key->otherwise == !pass)
                text_append(list.text, sizeof list.text, "%s%s", list.text[0] ? " " : "", key->name);
    return list;
}

static bool check_given(const SceneEntry *entry, const SceneKey *keys, const char *path)
{
    for (const SceneKey *key = keys; key->name; key++) {
        if (key->otherwise || scene_value(entry, key->name))
            continue;
        if (keys == entry->common || !entry->type->called)
            return scene_fault(entry, NULL, "%s has no '%s'; expected this key", path, key->name);
        return scene_fault(entry, NULL, "this %s has no '%s'; expected the keys: %s", entry->type->called, key->name,
                           list_keys(keys, false).text);
    }
    return true;
}

bool scene_check_entry(const SceneSection *section, const char *path, SceneEntry *entry)
{
    if (!check_given(entry, entry->common, path))
        return false;
    const SceneValue *type = scene_value(entry, "type");
    entry->type_number = type ? (size_t)type->number[0] : 0;
    entry->type = section->type_at(entry->type_number);
    for (size_t i = 0; i < entry->value_count; i++) {
        SceneValue *value = &entry->file->values[entry->first_value + i];
        const SceneKey *row = scene_row(entry, value->key->name);
        if (!row)
            return scene_fault(entry, value->key->name, "a %s has no '%s'; its keys are: %s", entry->type->called,
                               value->key->name, list_keys(entry->type->keys, true).text);
        value->key = row;
        if (!check_value(entry, path, value))
            return false;
    }
    return check_given(entry, entry->type->keys, path);
}
