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

const char *walk_scalar(const SceneWalk *walk)
{
    return walk->event.type == YAML_SCALAR_EVENT ? (const char *)walk->event.data.scalar.value : NULL;
}

bool walk_kind_fault(const SceneWalk *walk, const char *path, const char *expected)
{
    const char *word = walk_scalar(walk);
    char found[64] = "a list";
    if (walk->event.type == YAML_ALIAS_EVENT)
        return scene_fault_at(walk->file, walk_place(walk),
                              "an alias (*name); scene files cannot repeat values by aliases");
    if (walk->event.type == YAML_MAPPING_START_EVENT)
        snprintf(found, sizeof found, "keys with values");
    else if (word && walk->event.data.scalar.length == 0)
        snprintf(found, sizeof found, "nothing");
    else if (word)
        snprintf(found, sizeof found, "'%.50s'", word);
    return scene_fault_at(walk->file, walk_place(walk), "%s is %s; expected %s", path, found, expected);
}

static bool read_number(const SceneWalk *walk, const char *path, bool whole, double *number)
{
    const char *expected = whole ? "a whole number such as 100000" : "a number";
    const char *word = walk_scalar(walk), *at = word;
    if (!word)
        return walk_kind_fault(walk, path, expected);
    const char *end = word + walk->event.data.scalar.length;
    // YAML would read a number with a leading 0 by base eight.
    bool octal = word[strspn(word, "+-")] == '0' && end - word > 1;
    if (!text_number(&at, end, number) || at != end || (whole && (octal || word[strspn(word, "+-0123456789")])))
        return walk_kind_fault(walk, path, expected);
    if (fabs(*number) > SCENE_LARGEST_NUMBER)
        return scene_fault_at(walk->file, walk_place(walk), "%s is %.40s; expected a number between -1e9 and 1e9", path,
                              word);
    *number = whole ? *number : (double)(float)*number;
    return true;
}

static bool read_three(SceneWalk *walk, const char *path, SceneValue *value)
{
    int count = 0;
    if (walk->event.type != YAML_SEQUENCE_START_EVENT)
        return walk_kind_fault(walk, path, "3 numbers in brackets");
    for (; walk_next(walk) && walk->event.type != YAML_SEQUENCE_END_EVENT; count++) {
        char part[WALK_PATH];
        double number;
        snprintf(part, sizeof part, "%s[%d]", path, count);
        if (!read_number(walk, part, false, &number))
            return false;
        if (count < 3) {
            value->number[count] = number;
            value->part[count] = walk_place(walk);
        }
    }
    if (walk->event.type != YAML_SEQUENCE_END_EVENT)
        return false;
    return count == 3 || scene_fault_at(walk->file, value->place, "%s has %d number%s; expected 3", path, count,
                                        count == 1 ? "" : "s");
}

static bool read_word(const SceneWalk *walk, const char *path, SceneValue *value)
{
    const char *word = walk_scalar(walk);
    if (!word || !word[0] || strlen(word) != walk->event.data.scalar.length)
        return walk_kind_fault(walk, path, "a word");
    value->word = strdup(word);
    return value->word || scene_out_of_memory(walk->file);
}

static const char *type_name(const void *section, size_t i)
{
    const SceneType *type = scene_type_at(section, i);
    return type ? type->name : NULL;
}

static bool read_type(const SceneWalk *walk, const SceneSection *section, const char *path, SceneValue *value)
{
    size_t number;
    const char *word = walk_scalar(walk);
    if (!word)
        return walk_kind_fault(walk, path, "a word");
    if (!text_find_name(word, type_name, section, &number))
        return scene_fault_at(walk->file, walk_place(walk), "%s is '%.50s'; %s", path, word,
                              text_suggest(word, type_name, section).text);
    value->number[0] = (double)number;
    return true;
}

bool walk_read_value(SceneWalk *walk, const SceneSection *section, const char *path, SceneValue *value)
{
    value->place = value->part[0] = walk_place(walk);
    SceneKeyKind kind = value->key->kind;
    if (kind == KEY_TYPE)
        return read_type(walk, section, path, value);
    if (kind == KEY_WORD)
        return read_word(walk, path, value);
    if (kind == KEY_THREE || kind == KEY_COLOUR)
        return read_three(walk, path, value);
    return read_number(walk, path, kind == KEY_WHOLE, value->number);
}
