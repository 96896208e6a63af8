// The points table: what each step is worth. A teacher edits tests/judge/points.txt; its comments tell how.
#pragma once

#include "judge/grade/grade.h"

typedef struct {
    double points[STEP_COUNT]; // in the order of step_table; their sum is `total`
    int stages;                // of the course, from the first: `stages 3`
    bool hidden[STEP_COUNT];
    char due[STEP_COUNT][16]; // "2026-12-01" or empty
    double picture_share;     // of a step's points: what hangs on its picture alone, 0…1
    // Of a stage's points, for each day after its due date and in all, 0…1; `make class` takes them off: it knows the days.
    double late_per_day, late_most;
} PointsTable;

// False with "file:line: …" in the error.
bool points_read(const char *path, PointsTable *table, Error *error);

// Fills in result->points, points_max, hidden and due from the statuses. After its due date no step is hidden any more.
void points_give(const PointsTable *table, StepResult *result);
