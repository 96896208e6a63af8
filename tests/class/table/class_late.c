// What being late costs: the points of each stage shrink by its own due date.
#include "base/text.h"
#include "class/table/class_table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define DAY 86400.0

// The first moment after the day: a submission in its last minute is in time.
static time_t end_of(const char *due)
{
    struct tm day = {.tm_isdst = -1};
    strptime(due, "%Y-%m-%d", &day);
    day.tm_mday++;
    day.tm_isdst = -1;
    return mktime(&day);
}

// Canvas puts LATE into the name of what came late.
static bool is_same_name(const char *a, const char *b)
{
    const char *late = strstr(a, "LATE_");
    return strcmp(a, b) == 0 ||
           (late && strncmp(a, b, (size_t)(late - a)) == 0 && strcmp(late + 5, b + (late - a)) == 0);
}

// What a stage had in a class that was graded before; 0: nothing.
static double points_before(const Csv *earlier, const char *name, int stage)
{
    size_t names, column;
    char title[20];
    snprintf(title, sizeof title, "stage_%d", stage);
    if (earlier->columns == 0 || !csv_find(earlier, "submission", &names) || !csv_find(earlier, title, &column))
        return 0.0;
    for (size_t r = 1; r < earlier->rows; r++)
        if (is_same_name(name, csv_cell(earlier, r, names)))
            return strtod(csv_cell(earlier, r, column), NULL);
    return 0.0;
}

void student_set_late(Student *student, const PointsTable *points, const Csv *earlier)
{
    if (points->late_per_day > 0.0 && student->submitted == 0 && strstr(student->name, "LATE_"))
        text_append(student->message, sizeof student->message,
                    "%sCanvas says that it is late, not by how much; a column `submitted` in the roster would",
                    *student->message ? "; " : "");
    if (student->submitted == 0 || points->late_per_day <= 0.0)
        return;
    for (size_t i = 0; i < STEP_COUNT; i++) {
        int stage = step_table[i].stage - 1;
        if ((i > 0 && step_table[i - 1].stage == step_table[i].stage) || !*points->due[i])
            continue; // a stage has one due date, which all of its steps have
        double days = ceil(difftime(student->submitted, end_of(points->due[i])) / DAY);
        if (days <= 0.0)
            continue;
        double off = student->stage_points[stage] * fmin(days * points->late_per_day, points->late_most);
        double before = points_before(earlier, student->name, stage + 1);
        if (before > student->stage_points[stage] - off) {
            text_append(student->message, sizeof student->message, "%sstage %d has the points that it had before",
                        *student->message ? "; " : "", stage + 1);
            student->points += before - student->stage_points[stage];
            student->stage_points[stage] = before;
            continue;
        }
        student->stage_points[stage] -= off;
        student->points -= off;
        student->penalty += off;
        student->late = fmax(student->late, days);
    }
}
