// Fields out of JSON objects, each of a known type; what is wrong is told with the field's path.
#ifndef PHOTONLAB_JUDGE_REPORT_FIELDS_H
#define PHOTONLAB_JUDGE_REPORT_FIELDS_H

#include "report.h"

#include <jansson.h>

// The object being read, and where it lies: "steps[3].checks[0]". After the first error the rest gives zeros and empty
// texts, so that a reader asks once, at its end.
typedef struct {
    Report *report;
    const json_t *object;
    char path[120];
    size_t taken; // fields read so far
    Error *error; // set: something was wrong
} Fields;

bool fields_good(const Fields *fields);
// False, with an error, when the object has fields that nobody took, or something was wrong before.
bool fields_end(Fields *fields);

const char *field_text(Fields *fields, const char *name, size_t most); // cleaned; of at most `most` bytes
bool field_truth(Fields *fields, const char *name);
double field_number(Fields *fields, const char *name, double least, double largest);
double field_number_or_null(Fields *fields, const char *name); // null: NaN
Status field_status(Fields *fields, const char *name);
// Its elements by json_array_get; *count of them, at most `most`.
const json_t *field_array(Fields *fields, const char *name, size_t most, size_t *count);
// Numbers, null for NaN.
const double *field_numbers(Fields *fields, const char *name, size_t most, size_t *count);
// The object inside this one; false when it is null, or when something is wrong.
bool field_object(Fields *fields, const char *name, Fields *inside);
// Element i of the array of that name.
Fields fields_of_element(Fields *fields, const char *name, const json_t *array, size_t i);

#endif
