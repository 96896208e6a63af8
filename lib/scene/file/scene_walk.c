#include "scene/file/scene_walk.h"

#include <stdio.h>

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
    WalkPath path = {"the scene"};
    if (!walk->section)
        return path;
    int used = snprintf(path.text, sizeof path.text, "%s", walk->section->name);
    if (walk->index >= 0)
        used += snprintf(path.text + used, sizeof path.text - (size_t)used, "[%d]", walk->index);
    if (walk->key)
        used += snprintf(path.text + used, sizeof path.text - (size_t)used, ".%.60s", walk->key);
    if (walk->part >= 0)
        snprintf(path.text + used, sizeof path.text - (size_t)used, "[%d]", walk->part);
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
        return scene_fault_at(walk->source, place_of_offset(walk, parser->problem_offset),
                              "this is no text (%s); expected a scene in YAML", problem);
    if (parser->problem_mark.index < walk->size && walk->text[parser->problem_mark.index] == '\t')
        return scene_fault_at(walk->source, at, "a tab where YAML wants spaces; indent with spaces");
    return scene_fault_at(walk->source, at, "this is not YAML: %s%s%s", problem, parser->context ? ", " : "",
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
        return scene_fault_at(walk->source, walk_place(walk),
                              "an alias (*name); scene files cannot repeat values by aliases");
    if (event->type == YAML_MAPPING_START_EVENT)
        snprintf(found, sizeof found, "keys with values");
    else if (event->type == YAML_SCALAR_EVENT && event->data.scalar.length == 0)
        snprintf(found, sizeof found, "nothing");
    else if (event->type == YAML_SCALAR_EVENT)
        snprintf(found, sizeof found, "'%.50s'", (const char *)event->data.scalar.value);
    return scene_fault_at(walk->source, walk_place(walk), "%s is %s; expected %s", walk_path(walk).text, found,
                          expected);
}
