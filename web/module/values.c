// Numbers of a scene file that sliders may change, and where they stand in its text.
#include "scene/file/scene_section.h"
#include "web/module/web.h"

#include "base/text.h"

#include <stdio.h>

static void list_range(const SceneRange *range)
{
    text_append(page.text, sizeof page.text, ",\"low\":%.9g,\"high\":%.9g,\"unit\":\"%s\"", range->low, range->high,
                range->unit ? range->unit : "");
}

// {"section", "entry": its number there, "type", "name", "key", "whole", "low", "high", "unit", and for each number its
// "value", "line" and "column"}.
static void list_value(const SceneEntry *entry, int number, const SceneValue *value)
{
    SceneValue *name = scene_value(entry, "name");
    text_append(page.text, sizeof page.text,
                "%s{\"section\":\"%s\",\"entry\":%d,\"type\":\"%s\",\"name\":", page.text[1] ? "," : "",
                entry->section->name, number, entry->type->name);
    web_append_quoted(name && name->word ? name->word : "");
    text_append(page.text, sizeof page.text, ",\"key\":\"%s\",\"whole\":%d", value->key->name,
                value->key->kind == KEY_WHOLE);
    list_range(&value->key->range);
    text_append(page.text, sizeof page.text, ",\"numbers\":[");
    int count = value->key->kind == KEY_THREE ? 3 : 1;
    for (int i = 0; i < count; i++) {
        ScenePlace place = count == 1 ? value->place : value->part[i];
        text_append(page.text, sizeof page.text, "%s{\"value\":%.9g,\"line\":%u,\"column\":%u}", i ? "," : "",
                    value->number[i], place.line, place.column);
    }
    text_append(page.text, sizeof page.text, "]}");
}

static bool is_offered(const SceneEntry *entry, const SceneValue *value)
{
    SceneKeyKind kind = value->key->kind;
    if (!value->given)
        return false;
    if (entry->section == &material_section)
        return kind == KEY_NUMBER || kind == KEY_WHOLE;
    return entry->section == &light_section && (kind == KEY_NUMBER || kind == KEY_WHOLE || kind == KEY_THREE);
}

// JSON, see list_value: the single numbers of materials, and of lights those and the places in space. "[]" for a text with a fault.
const char *EXPORT(web_values)(const char *text, size_t size)
{
    Error error = {""};
    SceneFile file = {.name = "", .error = &error};
    const SceneSection *section = NULL;
    int number = 0;
    snprintf(page.text, sizeof page.text, "[");
    bool sound = scene_read(text, size, &file);
    for (size_t e = 0; sound && e < file.entry_count; e++) {
        const SceneEntry *entry = &file.entries[e];
        number = entry->section == section ? number + 1 : 0;
        section = entry->section;
        for (size_t v = 0; v < entry->value_count; v++)
            if (is_offered(entry, &file.values[entry->first_value + v]) && strlen(page.text) + 1000 < sizeof page.text)
                list_value(entry, number, &file.values[entry->first_value + v]);
    }
    scene_file_free(&file);
    text_append(page.text, sizeof page.text, "]");
    return page.text;
}
