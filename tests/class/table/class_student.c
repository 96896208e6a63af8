// One submission's result, from OUT/<name>/report.json and graded.json.
#include "base/text.h"
#include "class/table/class_table.h"

#include <jansson.h>
#include <string.h>
#include <unistd.h>

static const char *text_in(const json_t *object, const char *name)
{
    const char *text = json_string_value(json_object_get(object, name));
    return text ? text : "";
}

static double number_in(const json_t *object, const char *name)
{
    return json_number_value(json_object_get(object, name));
}

// Of what is wrong in a way that has no name: that it did not end, or which check says so.
static void say_check(const json_t *step, char *said, size_t size)
{
    const char *endless = strstr(text_in(step, "message"), "it did not end within");
    const json_t *checks = json_object_get(step, "checks");
    snprintf(said, size, "%s", endless ? endless : "");
    for (size_t i = 0; !*said && i < json_array_size(checks); i++)
        if (strcmp(text_in(json_array_get(checks, i), "status"), status_table[STATUS_FAIL].name) == 0)
            snprintf(said, size, "wrong by the check “%.299s”", text_in(json_array_get(checks, i), "title"));
}

static void read_step(const json_t *json, Student *student)
{
    const StepInfo *info = step_find(text_in(json, "id"));
    if (!info)
        return;
    StudentStep *step = &student->steps[info - step_table];
    *step = (StudentStep){.there = true,
                          .points = number_in(json, "points"),
                          .points_max = number_in(json, "points_max"),
                          .hidden = json_is_true(json_object_get(json, "hidden"))};
    snprintf(step->status, sizeof step->status, "%s", text_in(json, "status"));
    snprintf(step->mistake, sizeof step->mistake, "%s", text_in(json, "mistake"));
    // What broke off says how; of what is wrong the likely mistake is told, by its short name where there is no sentence,
    // or which check failed.
    bool broke = strcmp(step->status, status_table[STATUS_ERROR].name) == 0;
    const char *words = text_in(json, broke ? "message" : "looks_like");
    snprintf(step->said, sizeof step->said, "%s", *words ? words : text_in(json, "mistake"));
    char *line = broke ? strstr(step->said, ", line ") : NULL; // each has another, and all mean the same
    if (line)
        *line = '\0';
    if (!*step->said)
        say_check(json, step->said, sizeof step->said);
    student->stage_points[info->stage - 1] += step->points;
}

static json_t *load(const char *directory, const char *name, const char *file)
{
    char path[4200];
    snprintf(path, sizeof path, "%.3000s/%.900s/%s", directory, name, file);
    return json_load_file(path, 0, NULL);
}

void student_read(const char *directory, const char *name, Student *student)
{
    char page[4200];
    *student = (Student){.name = name, .status = "not graded", .message = "grading did not get this far"};
    json_t *graded = load(directory, name, "graded.json");
    if (!graded)
        return;
    snprintf(student->status, sizeof student->status, "%s", text_in(graded, "status"));
    snprintf(student->message, sizeof student->message, "%s", text_in(graded, "message"));
    student->seconds = number_in(graded, "seconds");
    student->submitted = (time_t)number_in(graded, "submitted");
    json_decref(graded);
    json_t *report = load(directory, name, "report.json");
    student->points = number_in(report, "points");
    const json_t *steps_read = json_object_get(report, "steps");
    for (size_t i = 0; i < json_array_size(steps_read); i++)
        read_step(json_array_get(steps_read, i), student);
    json_decref(report);
    snprintf(page, sizeof page, "%.3000s/%.900s/index.html", directory, name);
    student->has_page = access(page, R_OK) == 0;
}

size_t student_count(const Student *student, const char *status)
{
    size_t count = 0;
    for (size_t i = 0; i < STEP_COUNT; i++)
        count += strcmp(student->steps[i].status, status) == 0;
    return count;
}

void student_mistakes(const Student *student, char *text, size_t size)
{
    *text = '\0';
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (*student->steps[i].said)
            text_append(text, size, "%s%s: %s", *text ? "; " : "", step_table[i].id,
                        *student->steps[i].mistake ? student->steps[i].mistake : student->steps[i].said);
}
