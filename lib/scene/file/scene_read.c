#include "scene/file/scene_read.h"

#include "base/array.h"
#include "base/text.h"
#include "scene/file/scene_walk.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

// Names for "did you mean": each once, though several types have a row of that name.
static const char *key_name(const void *section, size_t i)
{
    const SceneKey *key, *other;
    for (size_t k = 0; (key = scene_key_at(section, k)); k++) {
        size_t first = 0;
        while ((other = scene_key_at(section, first)) && strcmp(other->name, key->name) != 0)
            first++;
        if (first == k && i-- == 0)
            return key->name;
    }
    return NULL;
}

static const char *section_name(const void *unused, size_t i)
{
    (void)unused;
    return i < SCENE_SECTIONS ? scene_sections[i]->name : NULL;
}

// To the next key of a mapping: its name, or NULL at the end. False at a fault.
static bool next_key(SceneWalk *walk, const char **key)
{
    *key = NULL;
    if (!walk_next(walk))
        return false;
    if (walk->event.type == YAML_MAPPING_END_EVENT)
        return true;
    if (walk->event.type != YAML_SCALAR_EVENT)
        return scene_fault_at(walk->source, walk_place(walk), "a key must be a word; expected key: value");
    *key = (const char *)walk->event.data.scalar.value;
    return true;
}

static bool unknown_fault(const SceneWalk *walk, const char *key, TextNameAt name_at)
{
    char suggestion[300];
    text_suggest(suggestion, sizeof suggestion, key, name_at, walk->section);
    return scene_fault_at(walk->source, walk_place(walk), "unknown key '%.50s'; %s", key, suggestion);
}

static bool twice_fault(const SceneWalk *walk, const char *key)
{
    return scene_fault_at(walk->source, walk_place(walk), "the key '%s' stands here twice; expected it once", key);
}

// The value of a key; `read` holds those of the entry's keys above it.
static bool read_pair(SceneWalk *walk, const char *key, SceneValue *read, size_t count)
{
    SceneValue *value = &read[count];
    for (size_t i = 0; i < count; i++)
        if (strcmp(read[i].key->name, key) == 0)
            return twice_fault(walk, key);
    for (size_t i = 0; (value->key = scene_key_at(walk->section, i)); i++)
        if (strcmp(value->key->name, key) == 0)
            break;
    if (!value->key || count == MOST_SECTION_KEYS)
        return unknown_fault(walk, key, key_name);
    walk->key = value->key->name;
    if (!walk_next(walk))
        return false;
    value->given = true;
    value->place = walk_place(walk);
    bool fine = walk_read_value(walk, value);
    walk->key = NULL;
    return fine;
}

static bool read_entry(SceneWalk *walk, SceneEntry *entry)
{
    SceneValue read[MOST_SECTION_KEYS + 1] = {{.given = false}};
    size_t count = 0;
    const char *key = NULL;
    bool fine = walk->event.type == YAML_MAPPING_START_EVENT || walk_kind_fault(walk, "keys with values (key: value)");
    while (fine && (fine = next_key(walk, &key)) && key)
        fine = read_pair(walk, key, read, count++);
    fine = fine && scene_complete_entry(walk->section, walk_path(walk).text, read, count, entry);
    for (size_t i = 0; i < count; i++)
        free(read[i].word);
    return fine;
}

static SceneEntry *add_entry(const SceneWalk *walk, SceneList *list, ScenePlace place)
{
    SceneEntry *entries = array_reserve(list->entries, list->count, &list->capacity, sizeof *entries);
    if (!entries) {
        error_set(walk->source->error, "%s: not enough memory", walk->source->file);
        return NULL;
    }
    list->entries = entries;
    entries[list->count] = (SceneEntry){.source = walk->source, .place = place};
    return &entries[list->count++];
}

static bool read_list(SceneWalk *walk, SceneList *list)
{
    if (walk->event.type != YAML_SEQUENCE_START_EVENT)
        return walk_kind_fault(walk, "a list (one entry per '- ')");
    while (walk_next(walk)) {
        walk->index = -1;
        if (walk->event.type == YAML_SEQUENCE_END_EVENT)
            return true;
        if (list->count == walk->section->most)
            return scene_fault_at(walk->source, walk_place(walk), "%s has too many entries; expected at most %zu",
                                  walk->section->name, walk->section->most);
        walk->index = (int)list->count;
        SceneEntry *entry = add_entry(walk, list, walk_place(walk));
        if (!entry || !read_entry(walk, entry))
            return false;
    }
    return false;
}

static bool read_section(SceneWalk *walk, const SceneSection *section, SceneList *list)
{
    list->given = true;
    list->place = walk_place(walk);
    walk->section = section;
    bool fine;
    if (section->most)
        fine = read_list(walk, list);
    else {
        SceneEntry *entry = add_entry(walk, list, list->place);
        fine = entry && read_entry(walk, entry);
    }
    walk->section = NULL;
    return fine;
}

// A section that the file leaves out: a fault, or an entry of what holds otherwise.
static bool leave_out(const SceneWalk *walk, const SceneSection *section, SceneList *list)
{
    if (section->most)
        return !section->required || list->count ||
               scene_fault_at(walk->source, list->place, "the scene has no %s; expected at least one under '%s:'",
                              section->name, section->name);
    if (section->required)
        return scene_fault_at(walk->source, list->place, "the scene has no '%s'; expected this key", section->name);
    SceneEntry *entry = add_entry(walk, list, list->place);
    if (!entry)
        return false;
    return scene_complete_entry(section, section->name, NULL, 0, entry);
}

static bool read_sections(SceneWalk *walk, SceneList lists[SCENE_SECTIONS])
{
    const char *key;
    if (walk->event.type != YAML_MAPPING_START_EVENT)
        return walk_kind_fault(walk, "keys with values (key: value)");
    for (int i = 0; i < SCENE_SECTIONS; i++)
        lists[i].place = walk_place(walk);
    for (;;) {
        int i = 0;
        if (!next_key(walk, &key))
            return false;
        if (!key)
            break;
        while (i < SCENE_SECTIONS && strcmp(scene_sections[i]->name, key) != 0)
            i++;
        if (i == SCENE_SECTIONS)
            return unknown_fault(walk, key, section_name);
        if (lists[i].given)
            return twice_fault(walk, key);
        if (!walk_next(walk) || !read_section(walk, scene_sections[i], &lists[i]))
            return false;
    }
    bool fine = true;
    for (int i = 0; i < SCENE_SECTIONS && fine; i++)
        fine = lists[i].count || leave_out(walk, scene_sections[i], &lists[i]);
    return fine;
}

static bool read_text(SceneWalk *walk, SceneList lists[SCENE_SECTIONS])
{
    if (!walk_next(walk) || !walk_next(walk)) // start of stream, start of document
        return false;
    if (walk->event.type == YAML_STREAM_END_EVENT)
        return scene_fault_at(walk->source, (ScenePlace){1, 1},
                              "the file is empty; expected camera, materials, lights and shapes");
    if (!walk_next(walk) || !read_sections(walk, lists) || !walk_next(walk) || !walk_next(walk))
        return false;
    return walk->event.type == YAML_STREAM_END_EVENT ||
           scene_fault_at(walk->source, walk_place(walk), "a second document begins; expected one scene per file");
}

bool scene_read(const char *text, size_t size, const SceneSource *source, SceneList lists[SCENE_SECTIONS])
{
    SceneWalk walk = {.text = text, .size = size, .source = source, .index = -1, .part = -1};
    if (!yaml_parser_initialize(&walk.parser))
        return error_set(source->error, "%s: not enough memory", source->file);
    yaml_parser_set_input_string(&walk.parser, (const unsigned char *)text, size);
    bool fine = read_text(&walk, lists);
    yaml_event_delete(&walk.event);
    yaml_parser_delete(&walk.parser);
    return fine;
}

void scene_lists_free(SceneList lists[SCENE_SECTIONS])
{
    for (int i = 0; i < SCENE_SECTIONS; i++) {
        for (size_t e = 0; e < lists[i].count; e++) {
            SceneEntry *entry = &lists[i].entries[e];
            for (size_t v = 0; v < entry->value_count; v++)
                free(entry->values[v].word);
            free(entry->values);
        }
        free(lists[i].entries);
    }
}
