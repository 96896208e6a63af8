// Structs as JSON objects, by one table of their fields for writing and reading: what the judge writes is what is read.
#pragma once

#include "judge/report/report.h"

#include <jansson.h>

typedef enum {
    FIELD_TEXT,   // const char *, cleaned, of at most `largest` bytes
    FIELD_PATH,   // the same, a path below the report's directory, of at least `least` bytes
    FIELD_TRUTH,  // bool
    FIELD_WHOLE,  // int from `least` to `largest`
    FIELD_NUMBER, // double from `least` to `largest`
    FIELD_MAYBE,  // double, NaN for null
    FIELD_STATUS, // Status
    FIELD_VALUES, // const double *, NaN for null, and size_t: how many, at most `largest`
    FIELD_OBJECT, // a struct of the given shape; null when its first member, a pointer, is NULL
    FIELD_LIST    // const struct *, and size_t: how many, at most `largest`
} FieldKind;

typedef struct Shape Shape;

typedef struct {
    const char *name;
    FieldKind kind;
    size_t at; // where in the struct
    double least, largest;
    size_t count_at;
    const Shape *shape;
} Field;

struct Shape {
    size_t size; // of the struct
    const Field *fields;
    size_t count;
    void (*check)(const void *object, const char *path, Error *error); // once all fields are good; NULL: no more to say
};
#define FIELD_COUNT(fields) (sizeof(fields) / sizeof *(fields))

json_t *fields_write(const Shape *shape, const void *from);

// Reads every field, and no other may be there. The first thing that is wrong goes into the error, with its path:
// "report.json: steps[3].checks[0].p: expected a number or null; found a text". What is read belongs to the report.
bool fields_read(const Shape *shape, const json_t *object, const char *path, void *to, Report *report, Error *error);
