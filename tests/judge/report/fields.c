#include "judge/report/fields.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static json_t *number_json(double value)
{
    return isfinite(value) ? json_real(value) : json_null(); // JSON has no NaN
}

static void *pointer_at(const void *place)
{
    void *pointer;
    memcpy(&pointer, place, sizeof pointer);
    return pointer;
}

static json_t *list_json(const Field *field, const void *elements, size_t count)
{
    json_t *list = json_array();
    for (size_t i = 0; i < count; i++)
        json_array_append_new(list, field->kind == FIELD_VALUES
                                        ? number_json(((const double *)elements)[i])
                                        : fields_write(field->shape, (const char *)elements + i * field->shape->size));
    return list;
}

// Students' code prints what it likes.
static json_t *text_json(const char *text, size_t most)
{
    char *clean = text_clean(text, strlen(text), most);
    json_t *string = json_string(clean ? clean : "");
    free(clean);
    return string;
}

static json_t *field_json(const Field *field, const char *from)
{
    const void *at = from + field->at;
    switch (field->kind) {
    case FIELD_TEXT:
    case FIELD_PATH:
        return text_json(pointer_at(at), (size_t)field->largest);
    case FIELD_TRUTH:
        return json_boolean(*(const bool *)at);
    case FIELD_WHOLE:
        return json_integer(*(const int *)at);
    case FIELD_NUMBER:
    case FIELD_MAYBE:
        return number_json(*(const double *)at);
    case FIELD_STATUS:
        return json_string(status_table[*(const Status *)at].name);
    case FIELD_OBJECT:
        return pointer_at(at) ? fields_write(field->shape, at) : json_null();
    case FIELD_VALUES:
    case FIELD_LIST:
        return list_json(field, pointer_at(at), *(const size_t *)(const void *)(from + field->count_at));
    }
    return NULL;
}

json_t *fields_write(const Shape *shape, const void *from)
{
    json_t *object = json_object();
    for (size_t i = 0; i < shape->count; i++)
        json_object_set_new(object, shape->fields[i].name, field_json(&shape->fields[i], from));
    return object;
}

static void unexpected(Error *error, const char *path, const char *expected, const json_t *value)
{
    static const char *const kinds[] = {"an object", "a list", "a text", "a number",
                                        "a number",  "true",   "false",  "null"};
    error_set(error, "report.json: %s: expected %s; found %s", path, expected,
              value ? kinds[json_typeof(value)] : "nothing");
}

// Pictures lie below the report: a path that leads elsewhere would carry a file of this machine into the page.
static bool is_below(const char *path)
{
    return path[0] != '/' && strcmp(path, "..") != 0 && strncmp(path, "../", 3) != 0 && !strstr(path, "/../");
}

static const char *read_text(const Field *field, const json_t *value, const char *path, Report *report, Error *error)
{
    const char *text = json_string_value(value);
    char *clean = text ? text_clean(text, json_string_length(value), (size_t)field->largest) : NULL;
    if (!text)
        unexpected(error, path, "a text", value);
    else if (!clean)
        error_set(error, "report.json: no memory for its texts");
    else if (field->kind == FIELD_PATH && (strlen(clean) < (size_t)field->least || !is_below(clean)))
        error_set(error, "report.json: %s: expected a path below the report's directory; found \"%s\"", path, clean);
    size_t size = clean ? strlen(clean) + 1 : 1;
    char *kept = memcpy(report_keep(report, size), clean ? clean : "", size);
    free(clean);
    return kept;
}

static double read_number(const Field *field, const json_t *value, const char *path, Error *error)
{
    double number = json_number_value(value);
    if (!json_is_number(value))
        unexpected(error, path, "a number", value);
    else if (field->kind == FIELD_WHOLE && number != floor(number))
        unexpected(error, path, "a whole number", value);
    else if (!(number >= field->least && number <= field->largest))
        error_set(error, "report.json: %s: expected %g to %g; found %g", path, field->least, field->largest, number);
    else
        return number;
    return field->least;
}

static double read_maybe(const json_t *value, const char *path, const char *expected, Error *error)
{
    if (!json_is_number(value) && !json_is_null(value))
        unexpected(error, path, expected, value);
    return json_is_number(value) ? json_number_value(value) : (double)NAN;
}

static Status read_status(const json_t *value, const char *path, Error *error)
{
    for (int i = 0; json_is_string(value) && i < STATUSES; i++)
        if (strcmp(json_string_value(value), status_table[i].name) == 0)
            return (Status)i;
    unexpected(error, path, "pass, fail, error, todo or skip", value);
    return STATUS_SKIP;
}

static void *read_list(const Field *field, const json_t *value, const char *path, size_t *count, Report *report,
                       Error *error)
{
    size_t each = field->shape ? field->shape->size : sizeof(double);
    *count = json_array_size(value);
    if (!json_is_array(value))
        unexpected(error, path, "a list", value);
    else if (*count > (size_t)field->largest)
        error_set(error, "report.json: %s: expected at most %g entries; found %zu", path, field->largest, *count);
    if (error->message[0])
        *count = 0;
    char *elements = report_keep(report, (*count + 1) * each), place[160];
    for (size_t i = 0; i < *count; i++) {
        const json_t *element = json_array_get(value, i);
        snprintf(place, sizeof place, "%s[%zu]", path, i);
        if (field->shape)
            fields_read(field->shape, element, place, elements + i * each, report, error);
        else
            ((double *)(void *)elements)[i] = read_maybe(element, path, "numbers or null", error);
    }
    return elements;
}

static void read_field(const Field *field, const json_t *value, const char *path, char *to, Report *report,
                       Error *error)
{
    void *at = to + field->at, *pointer = NULL;
    switch (field->kind) {
    case FIELD_TEXT:
    case FIELD_PATH:
        *(const char **)at = read_text(field, value, path, report, error);
        break;
    case FIELD_TRUTH:
        if (!json_is_boolean(value))
            unexpected(error, path, "true or false", value);
        *(bool *)at = json_is_true(value);
        break;
    case FIELD_WHOLE:
        *(int *)at = (int)read_number(field, value, path, error);
        break;
    case FIELD_NUMBER:
        *(double *)at = read_number(field, value, path, error);
        break;
    case FIELD_MAYBE:
        *(double *)at = read_maybe(value, path, "a number or null", error);
        break;
    case FIELD_STATUS:
        *(Status *)at = read_status(value, path, error);
        break;
    case FIELD_OBJECT:
        if (json_is_object(value))
            fields_read(field->shape, value, path, at, report, error);
        else if (!json_is_null(value))
            unexpected(error, path, "an object or null", value);
        break;
    case FIELD_VALUES:
    case FIELD_LIST:
        pointer = read_list(field, value, path, (size_t *)(void *)(to + field->count_at), report, error);
        memcpy(at, &pointer, sizeof pointer);
        break;
    }
}

bool fields_read(const Shape *shape, const json_t *object, const char *path, void *to, Report *report, Error *error)
{
    char place[120];
    if (!json_is_object(object))
        unexpected(error, path, "an object", object);
    for (size_t i = 0; i < shape->count && !error->message[0]; i++) {
        const Field *field = &shape->fields[i];
        snprintf(place, sizeof place, "%.80s%s%s", path, *path ? "." : "", field->name);
        read_field(field, json_object_get(object, field->name), place, to, report, error);
    }
    size_t found = json_object_size(object);
    if (found != shape->count)
        error_set(error, "report.json: %s: expected %zu fields; found %zu", *path ? path : "the whole", shape->count,
                  found);
    if (!error->message[0] && shape->check)
        shape->check(to, path, error);
    return !error->message[0];
}
