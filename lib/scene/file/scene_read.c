#include "scene/file/scene_read.h"

#include "base/array.h"
#include "base/text.h"
#include "scene/file/scene_walk.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

// The rows of a section, by their names.
typedef struct {
    const SceneKey *row[MOST_SECTION_KEYS];
    size_t count;
} Rows;

static const char *row_name(const void *rows, size_t i)
{
    const Rows *known = rows;
    return i < known->count ? known->row[i]->name : NULL;
}

static const char *section_name(const void *unused, size_t i)
{
    (void)unused;
    return i < SCENE_SECTIONS ? scene_sections[i]->name : NULL;
}

#define MAPPING_END SIZE_MAX

// To the next key of a mapping: which of the names it is, or MAPPING_END.
static bool next_key(SceneWalk *walk, TextNameAt name_at, const void *names, size_t *which)
{
    *which = MAPPING_END;
    if (!walk_next(walk))
        return false;
    if (walk->event.type == YAML_MAPPING_END_EVENT)
        return true;
    if (walk->event.type != YAML_SCALAR_EVENT)
        return scene_fault_at(walk->source, walk_place(walk), "a key must be a word; expected key: value");
    const char *key = (const char *)walk->event.data.scalar.value, *name;
    for (size_t i = 0; (name = name_at(names, i)); i++) {
        *which = i;
        if (strcmp(name, key) == 0)
            return true;
    }
    char suggestion[300];
    text_suggest(suggestion, sizeof suggestion, key, name_at, names);
    return scene_fault_at(walk->source, walk_place(walk), "unknown key '%.50s'; %s", key, suggestion);
}

static bool twice_fault(const SceneWalk *walk, const char *key)
{
    return scene_fault_at(walk->source, walk_place(walk), "the key '%s' stands here twice; expected it once", key);
}

// The keys and values of an entry; read[i] is that of row i.
static bool read_values(SceneWalk *walk, const Rows *rows, SceneValue *read)
{
    size_t which;
    if (walk->event.type != YAML_MAPPING_START_EVENT)
        return walk_kind_fault(walk, "keys with values (key: value)");
    while (next_key(walk, row_name, rows, &which)) {
        if (which == MAPPING_END)
            return true;
        SceneValue *value = &read[which];
        if (value->given)
            return twice_fault(walk, value->key->name);
        walk->key = rows->row[which]->name;
        if (!walk_next(walk))
            return false;
        *value = (SceneValue){.key = rows->row[which], .given = true, .place = walk_place(walk)};
        if (!walk_read_value(walk, value))
            return false;
        walk->key = NULL;
    }
    return false;
}

static bool read_entry(SceneWalk *walk, const Rows *rows, SceneEntry *entry)
{
    SceneValue read[MOST_SECTION_KEYS] = {{.given = false}};
    bool fine = read_values(walk, rows, read) &&
                scene_complete_entry(walk->section, walk_path(walk).text, read, rows->count, entry);
    for (size_t i = 0; i < rows->count; i++)
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

static bool read_list(SceneWalk *walk, const Rows *rows, SceneList *list)
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
        if (!entry || !read_entry(walk, rows, entry))
            return false;
    }
    return false;
}

static bool read_section(SceneWalk *walk, const SceneSection *section, SceneList *list)
{
    Rows rows;
    rows.count = scene_section_keys(section, rows.row);
    list->given = true;
    list->place = walk_place(walk);
    walk->section = section;
    bool fine;
    if (section->most)
        fine = read_list(walk, &rows, list);
    else {
        SceneEntry *entry = add_entry(walk, list, list->place);
        fine = entry && read_entry(walk, &rows, entry);
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
    size_t which;
    if (walk->event.type != YAML_MAPPING_START_EVENT)
        return walk_kind_fault(walk, "keys with values (key: value)");
    for (int i = 0; i < SCENE_SECTIONS; i++)
        lists[i].place = walk_place(walk);
    while (next_key(walk, section_name, NULL, &which) && which != MAPPING_END) {
        if (lists[which].given)
            return twice_fault(walk, scene_sections[which]->name);
        if (!walk_next(walk) || !read_section(walk, scene_sections[which], &lists[which]))
            return false;
    }
    bool fine = which == MAPPING_END;
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
