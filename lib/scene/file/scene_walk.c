#include "scene/file/scene_walk.h"

#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static ScenePlace place_of(yaml_mark_t mark)
{
    return (ScenePlace){(uint32_t)mark.line + 1, (uint32_t)mark.column + 1};
}

ScenePlace walk_place(const SceneWalk *walk)
{
    return place_of(walk->event.start_mark);
}

WalkPath walk_path(const SceneWalk *walk)
{
    WalkPath path = {""};
    text_append(path.text, sizeof path.text, "%s", walk->section ? walk->section->name : "the scene");
    if (walk->index >= 0)
        text_append(path.text, sizeof path.text, "[%d]", walk->index);
    if (walk->key)
        text_append(path.text, sizeof path.text, ".%s", walk->key);
    if (walk->part >= 0)
        text_append(path.text, sizeof path.text, "[%d]", walk->part);
    return path;
}

// Where libyaml's reader stopped is known as a number of bytes only.
static ScenePlace place_of_offset(const SceneWalk *walk, size_t offset)
{
    ScenePlace place = {1, 1};
    for (size_t i = 0; i < offset && i < walk->size; i++) {
        place.column = walk->text[i] == '\n' ? 1 : place.column + 1;
        place.line += walk->text[i] == '\n';
    }
    return place;
}

static bool syntax_fault(const SceneWalk *walk)
{
    const yaml_parser_t *parser = &walk->parser;
    ScenePlace at = place_of(parser->problem_mark);
    const char *problem = parser->problem ? parser->problem : "cannot be read";
    if (parser->error == YAML_READER_ERROR)
        return scene_fault_at(walk->file, place_of_offset(walk, parser->problem_offset),
                              "this is no text (%s); expected a scene in YAML", problem);
    if (parser->problem_mark.index < walk->size && walk->text[parser->problem_mark.index] == '\t')
        return scene_fault_at(walk->file, at, "a tab where YAML wants spaces; indent with spaces");
    return scene_fault_at(walk->file, at, "this is not YAML: %s%s%s", problem, parser->context ? ", " : "",
                          parser->context ? parser->context : "");
}

bool walk_next(SceneWalk *walk)
{
    yaml_event_delete(&walk->event);
    return yaml_parser_parse(&walk->parser, &walk->event) || syntax_fault(walk);
}

bool walk_kind_fault(const SceneWalk *walk, const char *expected)
{
    const yaml_event_t *event = &walk->event;
    char found[64] = "a list";
    if (event->type == YAML_ALIAS_EVENT)
        return scene_fault_at(walk->file, walk_place(walk),
                              "an alias (*name); scene files cannot repeat values by aliases");
    if (event->type == YAML_MAPPING_START_EVENT)
        snprintf(found, sizeof found, "keys with values");
    else if (event->type == YAML_SCALAR_EVENT && event->data.scalar.length == 0)
        snprintf(found, sizeof found, "nothing");
    else if (event->type == YAML_SCALAR_EVENT)
        snprintf(found, sizeof found, "'%.50s'", (const char *)event->data.scalar.value);
    return scene_fault_at(walk->file, walk_place(walk), "%s is %s; expected %s", walk_path(walk).text, found, expected);
}

// The scalar at hand; NULL, with the fault told, when something else stands there.
static const char *scalar(const SceneWalk *walk, const char *expected)
{
    if (walk->event.type == YAML_SCALAR_EVENT)
        return (const char *)walk->event.data.scalar.value;
    walk_kind_fault(walk, expected);
    return NULL;
}

static bool read_number(const SceneWalk *walk, bool whole, double *number)
{
    const char *expected = whole ? "a whole number such as 100000" : "a number";
    const char *word = scalar(walk, expected), *at = word;
    if (!word)
        return false;
    const char *end = word + walk->event.data.scalar.length;
    // YAML would read a number with a leading 0 by base eight.
    bool octal = word[strspn(word, "+-")] == '0' && end - word > 1;
    if (!text_number(&at, end, number) || at != end || (whole && (octal || word[strspn(word, "+-0123456789")])))
        return walk_kind_fault(walk, expected);
    if (fabs(*number) > SCENE_LARGEST_NUMBER)
        return scene_fault_at(walk->file, walk_place(walk), "%s is %.40s; expected a number between -1e9 and 1e9",
                              walk_path(walk).text, word);
    *number = whole ? *number : (double)(float)*number;
    return true;
}

static bool read_three(SceneWalk *walk, SceneValue *value)
{
    if (walk->event.type != YAML_SEQUENCE_START_EVENT)
        return walk_kind_fault(walk, "3 numbers in brackets");
    int count = 0;
    for (; walk_next(walk) && walk->event.type != YAML_SEQUENCE_END_EVENT; count++) {
        double number;
        walk->part = count;
        if (!read_number(walk, false, &number))
            return false;
        if (count < 3) {
            value->number[count] = number;
            value->part[count] = walk_place(walk);
        }
    }
    walk->part = -1;
    if (walk->event.type != YAML_SEQUENCE_END_EVENT)
        return false;
    return count == 3 || scene_fault_at(walk->file, value->place, "%s has %d number%s; expected 3",
                                        walk_path(walk).text, count, count == 1 ? "" : "s");
}

static bool read_word(const SceneWalk *walk, SceneValue *value)
{
    const char *word = scalar(walk, "a word");
    if (!word)
        return false;
    if (!word[0] || strlen(word) != walk->event.data.scalar.length)
        return walk_kind_fault(walk, "a word");
    value->word = strdup(word);
    return value->word || error_set(walk->file->error, "%s: not enough memory", walk->file->name);
}

static const char *type_name(const void *section, size_t i)
{
    const SceneType *type = ((const SceneSection *)section)->type_at(i);
    return type ? type->name : NULL;
}

static bool read_type(const SceneWalk *walk, SceneValue *value)
{
    const char *word = scalar(walk, "a word"), *name;
    if (!word)
        return false;
    for (size_t i = 0; (name = type_name(walk->section, i)); i++) {
        value->number[0] = (double)i;
        if (strcmp(name, word) == 0)
            return true;
    }
    char suggestion[300];
    text_suggest(suggestion, sizeof suggestion, word, type_name, walk->section);
    return scene_fault_at(walk->file, walk_place(walk), "%s is '%.50s'; %s", walk_path(walk).text, word, suggestion);
}

bool walk_read_value(SceneWalk *walk, SceneValue *value)
{
    switch (value->key->kind) {
    case KEY_NUMBER:
        return read_number(walk, false, value->number);
    case KEY_WHOLE:
        return read_number(walk, true, value->number);
    case KEY_THREE:
    case KEY_COLOUR:
        return read_three(walk, value);
    case KEY_WORD:
        return read_word(walk, value);
    case KEY_TYPE:
        return read_type(walk, value);
    }
    return false;
}
