// One submission's result, from OUT/<name>/report.json and graded.json.
#include "class/table/class_table.h"

#include <jansson.h>
#include <string.h>
#include <unistd.h>

static void copy_text(const json_t *object, const char *name, char *to, size_t size)
{
    const char *text = json_string_value(json_object_get(object, name));
    snprintf(to, size, "%s", text ? text : "");
}

static double number_of(const json_t *object, const char *name)
{
    return json_number_value(json_object_get(object, name));
}

// Of what is wrong in a way that has no name: that it did not end, or which check says so.
static void say_check(const json_t *step, char *said, size_t size)
{
    const char *message = json_string_value(json_object_get(step, "message"));
    const char *endless = message ? strstr(message, "it did not end within") : NULL;
    size_t i;
    json_t *check;
    if (endless)
        snprintf(said, size, "%s", endless);
    else
        json_array_foreach(json_object_get(step, "checks"), i, check)
        {
            char status[8], title[300];
            copy_text(check, "status", status, sizeof status);
            copy_text(check, "title", title, sizeof title);
            if (!*said && strcmp(status, status_table[STATUS_FAIL].name) == 0)
                snprintf(said, size, "wrong by the check “%s”", title);
        }
}

static void read_step(const json_t *json, Student *student)
{
    const char *id = json_string_value(json_object_get(json, "id"));
    const StepInfo *step = id ? step_find(id) : NULL;
    if (!step)
        return;
    size_t i = (size_t)(step - step_table);
    student->steps[i].there = true;
    student->steps[i].points = number_of(json, "points");
    student->steps[i].points_max = number_of(json, "points_max");
    student->steps[i].hidden = json_is_true(json_object_get(json, "hidden"));
    copy_text(json, "status", student->steps[i].status, sizeof student->steps[i].status);
    copy_text(json, "mistake", student->steps[i].mistake, sizeof student->steps[i].mistake);
    // What broke off says how; of what is wrong the likely mistake is told, by its short name where there is no sentence,
    // or which check failed.
    bool broke = strcmp(student->steps[i].status, status_table[STATUS_ERROR].name) == 0;
    copy_text(json, broke ? "message" : "looks_like", student->steps[i].said, sizeof student->steps[i].said);
    char *line = broke ? strstr(student->steps[i].said, ", line ") : NULL; // each has another, and all mean the same
    if (line)
        *line = '\0';
    if (!*student->steps[i].said)
        copy_text(json, "mistake", student->steps[i].said, sizeof student->steps[i].said);
    if (!*student->steps[i].said)
        say_check(json, student->steps[i].said, sizeof student->steps[i].said);
    if (step->stage >= 1 && step->stage <= STAGE_COUNT)
        student->stage_points[step->stage - 1] += student->steps[i].points;
}

static void read_report(const json_t *report, Student *student)
{
    size_t i;
    json_t *step;
    json_array_foreach(json_object_get(report, "steps"), i, step) read_step(step, student);
    student->points = number_of(report, "points");
}

void student_read(const char *directory, const char *name, Student *student)
{
    char path[4200];
    *student = (Student){.name = name, .status = "not graded", .message = "grading did not get this far"};
    snprintf(path, sizeof path, "%.3000s/%.900s/graded.json", directory, name);
    json_t *graded = json_load_file(path, 0, NULL);
    if (!graded)
        return;
    copy_text(graded, "status", student->status, sizeof student->status);
    copy_text(graded, "message", student->message, sizeof student->message);
    student->seconds = number_of(graded, "seconds");
    student->submitted = (time_t)number_of(graded, "submitted");
    json_decref(graded);
    snprintf(path, sizeof path, "%.3000s/%.900s/report.json", directory, name);
    json_t *report = json_load_file(path, 0, NULL);
    if (report)
        read_report(report, student);
    json_decref(report);
    snprintf(path, sizeof path, "%.3000s/%.900s/index.html", directory, name);
    student->has_page = access(path, R_OK) == 0;
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
        if (*student->steps[i].said) {
            size_t used = strlen(text);
            snprintf(text + used, size - used, "%s%s: %s", used ? "; " : "", step_table[i].id,
                     *student->steps[i].mistake ? student->steps[i].mistake : student->steps[i].said);
        }
}
