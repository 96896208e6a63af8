#include "fields.h"

#include <math.h>
#include <string.h>

static const char *kind_of(const json_t *value)
{
    static const char *const kinds[] = {"an object", "a list", "a text", "a number",
                                        "a number",  "true",   "false",  "null"};
    return value ? kinds[json_typeof(value)] : "nothing";
}

static void unexpected(Fields *fields, const char *name, const char *expected, const json_t *value)
{
    error_set(fields->error, "report.json: %s%s%s: expected %s; found %s", fields->path, *fields->path ? "." : "", name,
              expected, kind_of(value));
}

static const json_t *take(Fields *fields, const char *name)
{
    fields->taken++;
    return json_object_get(fields->object, name);
}

bool fields_good(const Fields *fields)
{
    return fields->error->message[0] == '\0';
}

bool fields_end(Fields *fields)
{
    if (fields_good(fields) && json_object_size(fields->object) != fields->taken)
        error_set(fields->error, "report.json: %s: expected %zu fields; found %zu",
                  *fields->path ? fields->path : "the whole", fields->taken, json_object_size(fields->object));
    return fields_good(fields);
}

const char *field_text(Fields *fields, const char *name, size_t most)
{
    const json_t *value = take(fields, name);
    if (!json_is_string(value)) {
        unexpected(fields, name, "a text", value);
        return "";
    }
    char *clean = text_clean(json_string_value(value), json_string_length(value), most);
    if (!clean) {
        error_set(fields->error, "report.json: no memory for its texts");
        return "";
    }
    size_t size = strlen(clean) + 1;
    char *kept = memcpy(report_keep(fields->report, size), clean, size);
    free(clean);
    return kept;
}

bool field_truth(Fields *fields, const char *name)
{
    const json_t *value = take(fields, name);
    if (!json_is_boolean(value))
        unexpected(fields, name, "true or false", value);
    return json_is_true(value);
}

double field_number(Fields *fields, const char *name, double least, double largest)
{
    const json_t *value = take(fields, name);
    double number = json_number_value(value);
    if (!json_is_number(value))
        unexpected(fields, name, "a number", value);
    else if (!(number >= least && number <= largest))
        error_set(fields->error, "report.json: %s%s%s: expected %g to %g; found %g", fields->path,
                  *fields->path ? "." : "", name, least, largest, number);
    return number;
}

double field_number_or_null(Fields *fields, const char *name)
{
    const json_t *value = take(fields, name);
    if (json_is_number(value))
        return json_number_value(value);
    if (!json_is_null(value))
        unexpected(fields, name, "a number or null", value);
    return (double)NAN;
}

Status field_status(Fields *fields, const char *name)
{
    const json_t *value = take(fields, name);
    for (int i = 0; json_is_string(value) && i < STATUSES; i++)
        if (strcmp(json_string_value(value), status_table[i].name) == 0)
            return (Status)i;
    unexpected(fields, name, "pass, fail, error, todo or skip", value);
    return STATUS_SKIP;
}

const json_t *field_array(Fields *fields, const char *name, size_t most, size_t *count)
{
    const json_t *value = take(fields, name);
    *count = 0;
    if (!json_is_array(value))
        unexpected(fields, name, "a list", value);
    else if (json_array_size(value) > most)
        error_set(fields->error, "report.json: %s%s%s: expected at most %zu entries; found %zu", fields->path,
                  *fields->path ? "." : "", name, most, json_array_size(value));
    else
        *count = json_array_size(value);
    return value;
}

const double *field_numbers(Fields *fields, const char *name, size_t most, size_t *count)
{
    const json_t *array = field_array(fields, name, most, count);
    double *numbers = report_keep(fields->report, (*count + 1) * sizeof *numbers);
    for (size_t i = 0; i < *count; i++) {
        const json_t *value = json_array_get(array, i);
        if (!json_is_number(value) && !json_is_null(value))
            unexpected(fields, name, "numbers or null", value);
        numbers[i] = json_is_number(value) ? json_number_value(value) : (double)NAN;
    }
    return numbers;
}

static Fields inside_of(Fields *fields, const json_t *object)
{
    return (Fields){.report = fields->report, .object = object, .error = fields->error};
}

bool field_object(Fields *fields, const char *name, Fields *inside)
{
    const json_t *value = take(fields, name);
    *inside = inside_of(fields, value);
    snprintf(inside->path, sizeof inside->path, "%.80s%s%s", fields->path, *fields->path ? "." : "", name);
    if (!json_is_object(value) && !json_is_null(value))
        unexpected(fields, name, "an object or null", value);
    return json_is_object(value) && fields_good(fields);
}

Fields fields_of_element(Fields *fields, const char *name, const json_t *array, size_t i)
{
    const json_t *value = json_array_get(array, i);
    Fields inside = inside_of(fields, value);
    snprintf(inside.path, sizeof inside.path, "%.60s%s%s[%zu]", fields->path, *fields->path ? "." : "", name, i);
    if (!json_is_object(value))
        error_set(fields->error, "report.json: %s: expected an object; found %s", inside.path, kind_of(value));
    return inside;
}
