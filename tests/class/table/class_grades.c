// The file that Moodle or Canvas takes grades from: theirs, with the grades filled in.
#include "base/text.h"
#include "class/table/class_table.h"
#include "judge/report/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

// Canvas' columns after the section that are an assignment, "photonlab (4711)": all, or those of that title without its
// number. `names` lists them.
static size_t list_assignments(const Csv *csv, size_t section, const char *wanted, size_t *last, char *names,
                               size_t size)
{
    size_t count = 0;
    for (size_t c = section + 1; c < csv->columns; c++) {
        const char *title = csv_cell(csv, 0, c), *id = strrchr(title, '(');
        size_t digits = id ? strspn(id + 1, "0123456789") : 0;
        if (digits == 0 || strcmp(id + 1 + digits, ")") != 0)
            continue;
        bool same = !wanted || (title + strlen(wanted) + 1 == id && strncasecmp(title, wanted, strlen(wanted)) == 0);
        if (!same)
            continue;
        text_append(names, size, "%sGRADE='%s'", *names ? " or " : "", title);
        *last = c;
        count++;
    }
    return count;
}

static bool find_canvas(const Csv *csv, Grades *in, const char *column, Error *error)
{
    char names[400] = "", all[400] = "";
    size_t any;
    csv_find(csv, "Section", &in->section);
    for (size_t r = 1; r < csv->rows && in->possible == 0; r++)
        in->possible = strstr(csv_cell(csv, r, 0), "Points Possible") ? r : 0;
    if (column && csv_find(csv, column, &in->grade))
        return true;
    size_t count = list_assignments(csv, in->section, column, &in->grade, names, sizeof names);
    if (count == 1)
        return true;
    if (count > 1)
        return error_set(error, "the gradebook has %zu assignments; say which: %s", count, names);
    list_assignments(csv, in->section, NULL, &any, all, sizeof all);
    return error_set(error, "the gradebook has no assignment %s%s%s", column ? column : "like `photonlab (4711)`",
                     *all ? "; say which: " : "", all);
}

bool grades_find(const Roster *roster, RosterKind kind, const char *column, Grades *in, Error *error)
{
    const Csv *csv = &roster->csv;
    *in = (Grades){kind, csv->columns, csv->columns, csv->columns, csv->columns, csv->columns, 0};
    if (kind != roster->kind)
        return error_set(error, "%s",
                         kind == ROSTER_MOODLE
                             ? "FORMAT=moodle needs Moodle's grading worksheet as ROSTER=, with columns "
                               "Identifier and Grade"
                             : "FORMAT=canvas needs Canvas' exported gradebook as ROSTER=, with columns "
                               "Student, ID and Section");
    if (kind == ROSTER_CANVAS)
        return find_canvas(csv, in, column, error);
    if (column && !csv_find(csv, column, &in->grade))
        return error_set(error, "the roster has no column `%s` for the grades", column);
    csv_find(csv, "Maximum Grade", &in->maximum);
    csv_find(csv, "Grade can be changed", &in->changeable);
    csv_find(csv, "Feedback comments", &in->feedback);
    return column || csv_find(csv, "Grade", &in->grade);
}

static bool is_kept(const Table *table, const TableRow *row)
{
    const Csv *csv = &table->roster.csv;
    const Grades *in = &table->grades;
    const char *old = csv_cell(csv, row->roster_row, in->grade);
    bool excused = in->kind == ROSTER_CANVAS && (strcasecmp(old, "EX") == 0 || strcmp(old, "N/A") == 0);
    return strcmp(row->student->status, "not graded") == 0 || excused ||
           (in->changeable < csv->columns && strcasecmp(csv_cell(csv, row->roster_row, in->changeable), "No") == 0);
}

// Points as a share of what the course system takes for the most; what could not be graded stays as it was.
static const char *grade_of(const Table *table, const TableRow *row, char *text, size_t size)
{
    const Csv *csv = &table->roster.csv;
    const Grades *in = &table->grades;
    const Student *s = row->student;
    if (is_kept(table, row))
        return csv_cell(csv, row->roster_row, in->grade);
    double most = in->kind == ROSTER_CANVAS && in->possible > 0 ? atof(csv_cell(csv, in->possible, in->grade))
                  : in->maximum < csv->columns                  ? atof(csv_cell(csv, row->roster_row, in->maximum))
                                                                : 0.0;
    double share = s->points_max > 0.0 ? s->points / s->points_max : 0.0;
    snprintf(text, size, "%.2f", most > 0.0 ? share * most : s->points);
    return text;
}

// Points by stage, without those of which nothing may be known yet.
static void list_stages(const Table *table, const Student *s, char *text, size_t size)
{
    char got[40], most[40];
    const char *before = "";
    for (int stage = 1; stage <= STAGE_COUNT; stage++) {
        double all = 0.0;
        bool hidden = false;
        for (size_t i = 0; i < STEP_COUNT; i++)
            if (step_table[i].stage == stage) {
                all += table->points.points[i];
                hidden = hidden || s->steps[i].hidden;
            }
        if (all <= 0.0 || hidden)
            continue;
        text_append(text, size, "%sstage %d: %s of %s", before, stage,
                    text_points(s->stage_points[stage - 1], got, sizeof got), text_points(all, most, sizeof most));
        before = ", ";
    }
}

// The step that lost most of what is told of.
static const StepInfo *worst_step(const Student *s)
{
    size_t worst = STEP_COUNT;
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (*s->steps[i].said && !s->steps[i].hidden &&
            (worst == STEP_COUNT ||
             s->steps[i].points_max - s->steps[i].points > s->steps[worst].points_max - s->steps[worst].points))
            worst = i;
    return worst < STEP_COUNT ? &step_table[worst] : NULL;
}

#define OURS "photonlab: " // what begins so may be written anew; what a teacher has written stays

// Moodle's editor puts what it saves into a paragraph.
static bool is_ours(const char *feedback)
{
    while (*feedback == '<' || *feedback == ' ')
        feedback += *feedback == '<' ? strcspn(feedback, ">") + (strchr(feedback, '>') != NULL) : 1;
    return strncmp(feedback, OURS, strlen(OURS)) == 0;
}

// A line for the student, which Moodle takes for HTML.
static const char *feedback_of(const Table *table, const TableRow *row, char *text, size_t size)
{
    const Student *s = row->student;
    const char *old = csv_cell(&table->roster.csv, row->roster_row, table->grades.feedback);
    char plain[1200] = OURS;
    if ((*old && !is_ours(old)) || is_kept(table, row) || strcmp(s->status, "no submission") == 0)
        return old;
    const StepInfo *step = worst_step(s);
    list_stages(table, s, plain, sizeof plain);
    if (s->penalty > 0.0)
        text_append(plain, sizeof plain, "; %.0f day%s late: −%.2f", s->late, s->late > 1.0 ? "s" : "", s->penalty);
    if (step)
        text_append(plain, sizeof plain, ". Step %s%s: %s", step->id,
                    *s->steps[step - step_table].mistake ? " looks like" : "", s->steps[step - step_table].said);
    if (strcmp(s->status, "graded") != 0)
        text_append(plain, sizeof plain, ". %s: %.400s", s->status, s->message);
    *text = '\0';
    size_t bytes;
    for (const char *at = plain; *at; at += bytes + !bytes) {
        unsigned long code;
        bytes = text_character((const unsigned char *)at, strlen(at), &code); // 0: one that a limit has cut
        const char *other = *at == '&' ? "&amp;" : *at == '<' ? "&lt;" : *at == '>' ? "&gt;" : *at == '\n' ? " " : NULL;
        text_append(text, size, "%.*s", other ? (int)strlen(other) : (int)bytes, other ? other : at);
    }
    return text;
}

static void write_line(FILE *stream, const Table *table, size_t row, const char *grade, const char *feedback)
{
    const Csv *csv = &table->roster.csv;
    const Grades *in = &table->grades;
    bool first = true;
    for (size_t c = 0; c < csv->columns; c++) {
        if (in->kind == ROSTER_CANVAS && c > in->section && c != in->grade)
            continue; // Canvas would take what stands there for a change
        csv_write(stream, c == in->grade ? grade : c == in->feedback ? feedback : csv_cell(csv, row, c), first);
        first = false;
    }
    fputc('\n', stream);
}

void grades_write(FILE *stream, const Table *table)
{
    const Csv *csv = &table->roster.csv;
    const Grades *in = &table->grades;
    char grade[40], feedback[4000];
    fputs(csv->marked ? MARK : "", stream);
    write_line(stream, table, 0, csv_cell(csv, 0, in->grade), "Feedback comments");
    if (in->possible > 0)
        write_line(stream, table, in->possible, csv_cell(csv, in->possible, in->grade), "");
    for (size_t i = 0; i < table->count; i++) {
        const TableRow *row = &table->rows[i];
        if (row->roster_row > 0)
            write_line(stream, table, row->roster_row, grade_of(table, row, grade, sizeof grade),
                       in->feedback < csv->columns ? feedback_of(table, row, feedback, sizeof feedback) : "");
    }
}
