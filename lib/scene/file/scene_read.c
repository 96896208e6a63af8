#include "scene/file/scene_walk.h"

#include "base/array.h"
#include "base/text.h"

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
        return scene_fault_at(walk->file, walk_place(walk), "a key must be a word; expected key: value");
    *key = (const char *)walk->event.data.scalar.value;
    return true;
}

static bool unknown_fault(const SceneWalk *walk, const char *key, TextNameAt name_at)
{
    char suggestion[300];
    text_suggest(suggestion, sizeof suggestion, key, name_at, walk->section);
    return scene_fault_at(walk->file, walk_place(walk), "unknown key '%.50s'; %s", key, suggestion);
}

static bool twice_fault(const SceneWalk *walk, const char *key)
{
    return scene_fault_at(walk->file, walk_place(walk), "the key '%s' stands here twice; expected it once", key);
}

static bool memory_fault(const SceneWalk *walk)
{
    return error_set(walk->file->error, "%s: not enough memory", walk->file->name);
}

// A key of the entry at hand, and its value.
static bool read_pair(SceneWalk *walk, SceneEntry *entry, const char *key)
{
    SceneFile *file = walk->file;
    const SceneKey *row;
    for (size_t i = 0; (row = scene_key_at(walk->section, i)); i++)
        if (strcmp(row->name, key) == 0)
            break;
    if (!row)
        return unknown_fault(walk, key, key_name);
    if (scene_value(entry, row->name))
        return twice_fault(walk, key);
    SceneValue *value = array_reserve(file->values, file->value_count, &file->value_capacity, sizeof *value);
    if (!value)
        return memory_fault(walk);
    file->values = value;
    value += file->value_count++;
    entry->value_count++;
    *value = (SceneValue){.key = row};
    if (!walk_next(walk))
        return false;
    value->place = walk_place(walk);
    walk->key = row->name;
    bool fine = walk_read_value(walk, value);
    walk->key = NULL;
    return fine;
}

static SceneEntry *add_entry(const SceneWalk *walk, int section, ScenePlace place)
{
    SceneFile *file = walk->file;
    SceneEntry *entry = array_reserve(file->entries, file->entry_count, &file->entry_capacity, sizeof *entry);
    if (!entry) {
        memory_fault(walk);
        return NULL;
    }
    file->entries = entry;
    entry += file->entry_count++;
    *entry = (SceneEntry){
        .file = file,
        .section = section,
        .common = scene_sections[section]->keys,
        .place = place,
        .first_value = file->value_count,
    };
    return entry;
}

static bool read_entry(SceneWalk *walk, int section)
{
    SceneEntry *entry = add_entry(walk, section, walk_place(walk));
    if (!entry)
        return false;
    if (walk->event.type != YAML_MAPPING_START_EVENT)
        return walk_kind_fault(walk, "keys with values (key: value)");
    const char *key = NULL;
    bool fine = true;
    while (fine && (fine = next_key(walk, &key)) && key)
        fine = read_pair(walk, entry, key);
    return fine && scene_check_entry(walk->section, walk_path(walk).text, entry);
}

static bool read_list(SceneWalk *walk, int section, size_t *count)
{
    if (walk->event.type != YAML_SEQUENCE_START_EVENT)
        return walk_kind_fault(walk, "a list (one entry per '- ')");
    for (; walk_next(walk); ++*count) {
        walk->index = -1;
        if (walk->event.type == YAML_SEQUENCE_END_EVENT)
            return true;
        if (*count == walk->section->most)
            return scene_fault_at(walk->file, walk_place(walk), "%s has too many entries; expected at most %zu",
                                  walk->section->name, walk->section->most);
        walk->index = (int)*count;
        if (!read_entry(walk, section))
            return false;
    }
    return false;
}

// A section without entries: a fault, or an entry of what holds otherwise.
static bool leave_out(const SceneWalk *walk, int number, ScenePlace place)
{
    const SceneSection *section = scene_sections[number];
    if (section->most)
        return !section->required ||
               scene_fault_at(walk->file, place, "the scene has no %s; expected at least one under '%s:'",
                              section->name, section->name);
    if (section->required)
        return scene_fault_at(walk->file, place, "the scene has no '%s'; expected this key", section->name);
    SceneEntry *entry = add_entry(walk, number, place);
    return entry && scene_check_entry(section, section->name, entry);
}

static int find_section(const char *name)
{
    int i = 0;
    while (i < SCENE_SECTIONS && strcmp(scene_sections[i]->name, name) != 0)
        i++;
    return i;
}

static bool read_sections(SceneWalk *walk)
{
    ScenePlace start = walk_place(walk), places[SCENE_SECTIONS] = {{0, 0}};
    size_t counts[SCENE_SECTIONS] = {0};
    const char *key = NULL;
    if (walk->event.type != YAML_MAPPING_START_EVENT)
        return walk_kind_fault(walk, "keys with values (key: value)");
    for (;;) {
        if (!next_key(walk, &key))
            return false;
        if (!key)
            break;
        int i = find_section(key);
        if (i == SCENE_SECTIONS)
            return unknown_fault(walk, key, section_name);
        if (places[i].line)
            return twice_fault(walk, key);
        if (!walk_next(walk))
            return false;
        places[i] = walk_place(walk);
        walk->section = scene_sections[i];
        if (!(walk->section->most ? read_list(walk, i, &counts[i]) : read_entry(walk, i)))
            return false;
        counts[i] += !walk->section->most;
        walk->section = NULL;
    }
    for (int i = 0; i < SCENE_SECTIONS; i++)
        if (!counts[i] && !leave_out(walk, i, places[i].line ? places[i] : start))
            return false;
    return true;
}

static bool read_text(SceneWalk *walk)
{
    if (!walk_next(walk) || !walk_next(walk)) // start of stream, start of document
        return false;
    if (walk->event.type == YAML_STREAM_END_EVENT)
        return scene_fault_at(walk->file, (ScenePlace){1, 1},
                              "the file is empty; expected camera, materials, lights and shapes");
    if (!walk_next(walk) || !read_sections(walk) || !walk_next(walk) || !walk_next(walk))
        return false;
    return walk->event.type == YAML_STREAM_END_EVENT ||
           scene_fault_at(walk->file, walk_place(walk), "a second document begins; expected one scene per file");
}

bool scene_read(const char *text, size_t size, SceneFile *file)
{
    SceneWalk walk = {.text = text, .size = size, .file = file, .index = -1, .part = -1};
    if (!yaml_parser_initialize(&walk.parser))
        return memory_fault(&walk);
    yaml_parser_set_input_string(&walk.parser, (const unsigned char *)text, size);
    bool fine = read_text(&walk);
    yaml_event_delete(&walk.event);
    yaml_parser_delete(&walk.parser);
    return fine;
}

void scene_file_free(SceneFile *file)
{
    for (size_t i = 0; i < file->value_count; i++)
        free(file->values[i].word);
    free(file->values);
    free(file->entries);
}
