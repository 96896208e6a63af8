// What became of a step, a check or a stage, and what that is called: on the terminal, in report.json and in what is made
// of it.
#pragma once

#include <stdbool.h>

typedef enum { STATUS_PASS, STATUS_FAIL, STATUS_ERROR, STATUS_TODO, STATUS_SKIP, STATUSES } Status;

typedef struct {
    const char *name; // "pass", in files
    const char *mark; // "✓"
    const char *words;
} StatusInfo;
extern const StatusInfo status_table[STATUSES];

bool status_is_wrong(Status status); // fails, or did not get through
