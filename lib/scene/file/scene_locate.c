#include "scene/file/scene_locate.h"
#include "scene/limits.h"

#include "base/text.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <yaml.h>

// A walk along the events of the text, schema in hand. It ends early when it finds the target or a fault.
typedef struct {
    yaml_parser_t parser;
    yaml_event_t event;
    const char *text, *file;
    size_t size;
    const char *target; // path to look for, NULL: none
    yaml_mark_t found;  // of the target, or of the last part of its path so far
    char path[128];     // of the value at hand
    Error *error;
} Walk;

typedef const cyaml_schema_value_t *Schema;

static bool walk_value(Walk *walk, Schema schema);

static bool fault(Walk *walk, yaml_mark_t at, const char *format, ...)
{
    char what[600];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    text_make_printable(what);
    return error_set(walk->error, "%s:%zu:%zu: %s", walk->file, at.line + 1, at.column + 1, what);
}

// Where libyaml's reader stopped is known as a number of bytes only.
static yaml_mark_t mark_of_offset(const Walk *walk, size_t offset)
{
    yaml_mark_t mark = {0};
    for (size_t i = 0; i < offset && i < walk->size; i++) {
        mark.column = walk->text[i] == '\n' ? 0 : mark.column + 1;
        mark.line += walk->text[i] == '\n';
    }
    return mark;
}

static bool syntax_fault(Walk *walk)
{
    const yaml_parser_t *parser = &walk->parser;
    yaml_mark_t at = parser->problem_mark;
    const char *problem = parser->problem ? parser->problem : "cannot be read";
    if (parser->error == YAML_READER_ERROR)
        return fault(walk, mark_of_offset(walk, parser->problem_offset),
                     "this is no text (%s); expected a scene in YAML", problem);
    if (at.index < walk->size && walk->text[at.index] == '\t')
        return fault(walk, at, "a tab where YAML wants spaces; indent with spaces");
    return fault(walk, at, "this is not YAML: %s%s%s", problem, parser->context ? ", " : "",
                 parser->context ? parser->context : "");
}

static bool next(Walk *walk)
{
    yaml_event_delete(&walk->event);
    return yaml_parser_parse(&walk->parser, &walk->event) || syntax_fault(walk);
}

static const char *field_key(const void *fields, size_t i)
{
    return ((const cyaml_schema_field_t *)fields)[i].key;
}

static const char *enum_name(const void *schema, size_t i)
{
    Schema value = schema;
    return i < value->enumeration.count ? value->enumeration.strings[i].str : NULL;
}

static bool type_fault(Walk *walk, Schema schema)
{
    static const char *const expected[CYAML__TYPE_COUNT] = {
        [CYAML_INT] = "a whole number such as 100000",
        [CYAML_FLOAT] = "a number",
        [CYAML_ENUM] = "a word",
        [CYAML_STRING] = "a word",
        [CYAML_MAPPING] = "keys with values (key: value)",
        [CYAML_SEQUENCE] = "a list (one entry per '- ')",
        [CYAML_SEQUENCE_FIXED] = "3 numbers in brackets",
    };
    const yaml_event_t *event = &walk->event;
    char found[64] = "a list";
    if (event->type == YAML_ALIAS_EVENT)
        return fault(walk, event->start_mark, "an alias (*name); scene files cannot repeat values by aliases");
    if (event->type == YAML_MAPPING_START_EVENT)
        snprintf(found, sizeof found, "keys with values");
    else if (event->type == YAML_SCALAR_EVENT && event->data.scalar.length == 0)
        snprintf(found, sizeof found, "nothing");
    else if (event->type == YAML_SCALAR_EVENT)
        snprintf(found, sizeof found, "'%.50s'", (const char *)event->data.scalar.value);
    return fault(walk, event->start_mark, "%s is %s; expected %s", walk->path[0] ? walk->path : "the scene", found,
                 expected[schema->type]);
}

static bool check_number(Walk *walk, Schema schema)
{
    const char *word = (const char *)walk->event.data.scalar.value, *at = word;
    const char *end = word + walk->event.data.scalar.length;
    double value = 0;
    bool whole = word[strspn(word, "+-0123456789")] == '\0';
    // A leading 0 would make libcyaml read the number by base eight.
    if (word[strspn(word, "+-")] == '0' && end - word > 1)
        whole = false;
    if (!text_number(&at, end, &value) || at != end || (schema->type == CYAML_INT && !whole))
        return type_fault(walk, schema);
    return fabs(value) <= SCENE_LARGEST_NUMBER ||
           fault(walk, walk->event.start_mark, "%s is %.40s; expected a number between -1e9 and 1e9", walk->path, word);
}

static bool check_choice(Walk *walk, Schema schema)
{
    const char *word = (const char *)walk->event.data.scalar.value, *name;
    for (size_t i = 0; (name = enum_name(schema, i)); i++)
        if (strcmp(name, word) == 0)
            return true;
    char suggestion[300];
    text_suggest(suggestion, sizeof suggestion, word, enum_name, schema);
    return fault(walk, walk->event.start_mark, "%s is '%.50s'; %s", walk->path, word, suggestion);
}

static bool check_word(Walk *walk, Schema schema)
{
    size_t length = walk->event.data.scalar.length;
    if (length < schema->string.min || strlen((const char *)walk->event.data.scalar.value) != length)
        return type_fault(walk, schema);
    return length <= schema->string.max ||
           fault(walk, walk->event.start_mark, "%s is %zu characters long; expected at most %u", walk->path, length,
                 (unsigned)schema->string.max);
}

static bool walk_sequence(Walk *walk, Schema schema)
{
    yaml_mark_t start = walk->event.start_mark;
    size_t parent = strlen(walk->path), count = 0;
    for (;; count++) {
        if (!next(walk))
            return false;
        if (walk->event.type == YAML_SEQUENCE_END_EVENT)
            break;
        if (count == schema->sequence.max && schema->type == CYAML_SEQUENCE)
            return fault(walk, walk->event.start_mark, "%s has too many entries; expected at most %u", walk->path,
                         (unsigned)schema->sequence.max);
        snprintf(walk->path + parent, sizeof walk->path - parent, "[%zu]", count);
        if (!walk_value(walk, schema->sequence.entry))
            return false;
        walk->path[parent] = '\0';
    }
    return schema->type == CYAML_SEQUENCE || count == schema->sequence.min ||
           fault(walk, start, "%s has %zu number%s; expected %u", walk->path, count, count == 1 ? "" : "s",
                 (unsigned)schema->sequence.min);
}

// The field that the key at hand names; NULL with an error when it is unknown or was there before.
static const cyaml_schema_field_t *check_key(Walk *walk, const cyaml_schema_field_t *fields, unsigned *seen)
{
    yaml_mark_t at = walk->event.start_mark;
    const char *key = (const char *)walk->event.data.scalar.value;
    for (size_t i = 0; fields[i].key; i++) {
        if (strcmp(fields[i].key, key) != 0)
            continue;
        if (*seen & 1u << i)
            fault(walk, at, "the key '%s' stands here twice; expected it once", key);
        bool first = !(*seen & 1u << i);
        *seen |= 1u << i;
        return first ? &fields[i] : NULL;
    }
    char suggestion[300];
    text_suggest(suggestion, sizeof suggestion, key, field_key, fields);
    fault(walk, at, "unknown key '%.50s'; %s", key, suggestion);
    return NULL;
}

static bool walk_mapping(Walk *walk, Schema schema)
{
    const cyaml_schema_field_t *fields = schema->mapping.fields, *field;
    yaml_mark_t start = walk->event.start_mark;
    size_t parent = strlen(walk->path);
    unsigned seen = 0;
    for (;;) {
        if (!next(walk))
            return false;
        if (walk->event.type == YAML_MAPPING_END_EVENT)
            break;
        if (walk->event.type != YAML_SCALAR_EVENT)
            return fault(walk, walk->event.start_mark, "a key must be a word; expected key: value");
        if (!(field = check_key(walk, fields, &seen)) || !next(walk))
            return false;
        snprintf(walk->path + parent, sizeof walk->path - parent, "%s%s", parent ? "." : "", field->key);
        if (!walk_value(walk, &field->value))
            return false;
        walk->path[parent] = '\0';
    }
    for (size_t i = 0; fields[i].key; i++) {
        if (!(fields[i].value.flags & CYAML_FLAG_OPTIONAL) && !(seen & 1u << i))
            return fault(walk, start, "%s has no '%s'; expected this key", parent ? walk->path : "the scene",
                         fields[i].key);
    }
    return true;
}

// Notes where the value at hand stands if the target's path leads to it. True when it is the target.
static bool is_target(Walk *walk)
{
    if (!walk->target)
        return false;
    size_t length = strlen(walk->path);
    if (strncmp(walk->path, walk->target, length) != 0)
        return false;
    char after = walk->target[length];
    if (length && after && after != '.' && after != '[')
        return false;
    walk->found = walk->event.start_mark;
    return after == '\0';
}

static bool walk_value(Walk *walk, Schema schema)
{
    yaml_event_type_t type = walk->event.type;
    if (is_target(walk))
        return false;
    if (schema->type == CYAML_MAPPING)
        return type == YAML_MAPPING_START_EVENT ? walk_mapping(walk, schema) : type_fault(walk, schema);
    if (schema->type == CYAML_SEQUENCE || schema->type == CYAML_SEQUENCE_FIXED)
        return type == YAML_SEQUENCE_START_EVENT ? walk_sequence(walk, schema) : type_fault(walk, schema);
    if (type != YAML_SCALAR_EVENT)
        return type_fault(walk, schema);
    if (schema->type == CYAML_INT || schema->type == CYAML_FLOAT)
        return check_number(walk, schema);
    return schema->type == CYAML_ENUM ? check_choice(walk, schema) : check_word(walk, schema);
}

static bool walk_text(Walk *walk)
{
    if (!next(walk) || !next(walk)) // start of stream, start of document
        return false;
    if (walk->event.type == YAML_STREAM_END_EVENT)
        return fault(walk, (yaml_mark_t){0}, "the file is empty; expected camera, materials, lights and shapes");
    if (!next(walk) || !walk_value(walk, &scene_schema) || !next(walk) || !next(walk))
        return false;
    return walk->event.type == YAML_STREAM_END_EVENT ||
           fault(walk, walk->event.start_mark, "a second document begins; expected one scene per file");
}

static bool walk_start_to_end(Walk *walk)
{
    if (!yaml_parser_initialize(&walk->parser))
        return error_set(walk->error, "%s: not enough memory", walk->file);
    yaml_parser_set_input_string(&walk->parser, (const unsigned char *)walk->text, walk->size);
    bool fine = walk_text(walk);
    yaml_event_delete(&walk->event);
    yaml_parser_delete(&walk->parser);
    return fine;
}

bool scene_check_text(const char *text, size_t size, const char *file, Error *error)
{
    Walk walk = {.text = text, .size = size, .file = file, .error = error};
    return walk_start_to_end(&walk);
}

void scene_locate(const char *text, size_t size, const char *path, size_t *line, size_t *column)
{
    Walk walk = {.text = text, .size = size, .file = "", .target = path};
    walk_start_to_end(&walk);
    *line = walk.found.line + 1;
    *column = walk.found.column + 1;
}
