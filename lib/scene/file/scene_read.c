#include "scene/file/scene_walk.h"

#include "base/array.h"
#include "base/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_ROWS = 100 }; // of a section, with those of all its types

static const char *key_name(const void *section, size_t i)
{
    const SceneKey *key = scene_key_at(section, i);
    return key ? key->name : NULL;
}

static const char *section_name(const void *unused, size_t i)
{
    (void)unused;
    return i < SCENE_SECTIONS ? scene_sections[i]->name : NULL;
}

// To the next key of a mapping, which must be a name of the list and there for the first time, and on to its value. Gives
// its number in the list, −1 at the end. False at a fault.
static bool next_key(SceneWalk *walk, TextNameAt name_at, const void *list, bool seen[MOST_ROWS], int *number)
{
    *number = -1;
    if (!walk_next(walk))
        return false;
    if (walk->event.type == YAML_MAPPING_END_EVENT)
        return true;
    const char *key = walk_scalar(walk);
    size_t i;
    if (!key)
        return scene_fault_at(walk->file, walk_place(walk), "a key must be a word; expected key: value");
    if (!text_find_name(key, name_at, list, &i) || i >= MOST_ROWS)
        return scene_fault_at(walk->file, walk_place(walk), "unknown key '%.50s'; %s", key,
                              text_suggest(key, name_at, list).text);
    if (seen[i])
        return scene_fault_at(walk->file, walk_place(walk), "the key '%s' stands here twice; expected it once", key);
    seen[i] = true;
    *number = (int)i;
    return walk_next(walk);
}

static SceneEntry *add_entry(SceneFile *file, const SceneSection *section, ScenePlace place)
{
    if (!array_reserve(&file->entries, file->entry_count + 1, &file->entry_capacity, sizeof(SceneEntry))) {
        scene_out_of_memory(file);
        return NULL;
    }
    SceneEntry *entry = &file->entries[file->entry_count++];
    *entry = (SceneEntry){.file = file, .section = section, .place = place, .first_value = file->value_count};
    return entry;
}

static bool read_entry(SceneWalk *walk, const SceneSection *section, const char *path)
{
    SceneEntry *entry = add_entry(walk->file, section, walk_place(walk));
    if (!entry)
        return false;
    if (walk->event.type != YAML_MAPPING_START_EVENT)
        return walk_kind_fault(walk, path, "keys with values (key: value)");
    bool seen[MOST_ROWS] = {false}, fine;
    int row;
    while ((fine = next_key(walk, key_name, section, seen, &row)) && row >= 0) {
        SceneValue *value = scene_add_value(walk->file, entry, scene_key_at(section, (size_t)row));
        if (!value)
            return false;
        char of[WALK_PATH];
        value->given = true;
        snprintf(of, sizeof of, "%s.%s", path, value->key->name);
        if (!walk_read_value(walk, section, of, value))
            return false;
    }
    return fine && scene_complete(walk->file, entry, path);
}

static bool read_list(SceneWalk *walk, const SceneSection *section)
{
    if (walk->event.type != YAML_SEQUENCE_START_EVENT)
        return walk_kind_fault(walk, section->name, "a list (one entry per '- ')");
    for (size_t count = 0; walk_next(walk); count++) {
        char path[WALK_PATH];
        if (walk->event.type == YAML_SEQUENCE_END_EVENT)
            return true;
        if (count == section->most)
            return scene_fault_at(walk->file, walk_place(walk), "%s has too many entries; expected at most %zu",
                                  section->name, section->most);
        snprintf(path, sizeof path, "%s[%zu]", section->name, count);
        if (!read_entry(walk, section, path))
            return false;
    }
    return false;
}

// A section without entries: a fault, or an entry of what holds otherwise.
static bool leave_out(SceneFile *file, const SceneSection *section, ScenePlace place)
{
    if (section->most)
        return !section->required ||
               scene_fault_at(file, place, "the scene has no %s; expected at least one under '%s:'", section->name,
                              section->name);
    if (section->required)
        return scene_fault_at(file, place, "the scene has no '%s'; expected this key", section->name);
    SceneEntry *entry = add_entry(file, section, place);
    return entry && scene_complete(file, entry, section->name);
}

static bool read_sections(SceneWalk *walk)
{
    ScenePlace start = walk_place(walk), places[SCENE_SECTIONS] = {{0, 0}};
    bool seen[MOST_ROWS] = {false}, filled[SCENE_SECTIONS] = {false}, fine;
    int i;
    if (walk->event.type != YAML_MAPPING_START_EVENT)
        return walk_kind_fault(walk, "the scene", "keys with values (key: value)");
    while ((fine = next_key(walk, section_name, NULL, seen, &i)) && i >= 0) {
        const SceneSection *section = scene_sections[i];
        size_t before = walk->file->entry_count;
        places[i] = walk_place(walk);
        if (!(section->most ? read_list(walk, section) : read_entry(walk, section, section->name)))
            return false;
        filled[i] = walk->file->entry_count > before;
    }
    for (i = 0; fine && i < SCENE_SECTIONS; i++)
        fine = filled[i] || leave_out(walk->file, scene_sections[i], seen[i] ? places[i] : start);
    return fine;
}

static bool read_text(SceneWalk *walk)
{
    if (!walk_next(walk) || !walk_next(walk)) // start of stream, start of document
        return false;
    if (walk->event.type == YAML_STREAM_END_EVENT)
        return scene_fault_at(walk->file, ((ScenePlace){1, 1}),
                              "the file is empty; expected camera, materials, lights and shapes");
    if (!walk_next(walk) || !read_sections(walk) || !walk_next(walk) || !walk_next(walk))
        return false;
    return walk->event.type == YAML_STREAM_END_EVENT ||
           scene_fault_at(walk->file, walk_place(walk), "a second document begins; expected one scene per file");
}

bool scene_read(const char *text, size_t size, SceneFile *file)
{
    SceneWalk walk = {.text = text, .size = size, .file = file};
    if (!yaml_parser_initialize(&walk.parser))
        return scene_out_of_memory(file);
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
