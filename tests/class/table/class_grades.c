// The file that Moodle or Canvas takes grades from: theirs, with the grades filled in->
#include "class/table/class_table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

// Canvas' columns after the section that are an assignment: "photonlab (4711)".
static size_t count_assignments(const Csv *csv, size_t section, size_t *last)
{
    size_t count = 0;
    for (size_t c = section + 1; c < csv->columns; c++) {
        const char *title = csv_cell(csv, 0, c), *id = strrchr(title, '(');
        size_t digits = id ? strspn(id + 1, "0123456789") : 0;
        if (digits > 0 && strcmp(id + 1 + digits, ")") == 0) {
            *last = c;
            count++;
        }
    }
    return count;
}

static bool find_canvas(const Csv *csv, Grades *in, const char *column, Error *error)
{
    csv_find(csv, "Section", &in->section);
    for (size_t r = 1; r < csv->rows && in->possible == 0; r++)
        in->possible = strstr(csv_cell(csv, r, 0), "Points Possible") ? r : 0;
    size_t count = column ? 1 : count_assignments(csv, in->section, &in->grade);
    return count == 1 ||
           error_set(error, "the gradebook has %zu assignments; say which: GRADE='%s', with the number behind it",
                     count, count ? csv_cell(csv, 0, in->grade) : "photonlab (4711)");
}

bool grades_find(const Roster *roster, RosterKind kind, const char *column, Grades *in, Error *error)
{
    const Csv *csv = &roster->csv;
    *in = (Grades){kind, csv->columns, csv->columns, csv->columns, csv->columns, 0};
    if (column && !csv_find(csv, column, &in->grade))
        return error_set(error, "the roster has no column `%s` for the grades", column);
    if (kind != roster->kind)
        return error_set(error, "%s",
                         kind == ROSTER_MOODLE
                             ? "FORMAT=moodle needs Moodle's grading worksheet as ROSTER=, with columns "
                               "Identifier and Grade"
                             : "FORMAT=canvas needs Canvas' exported gradebook as ROSTER=, with columns "
                               "Student, ID and Section");
    if (kind == ROSTER_CANVAS)
        return find_canvas(csv, in, column, error);
    csv_find(csv, "Maximum Grade", &in->maximum);
    csv_find(csv, "Grade can be changed", &in->changeable);
    return column || csv_find(csv, "Grade", &in->grade);
}

// Points as a share of what the course system takes for the most; what could not be graded stays as it was.
static const char *grade_of(const Table *table, const TableRow *row, char *text, size_t size)
{
    const Csv *csv = &table->roster.csv;
    const Grades *in = &table->grades;
    const Student *s = row->student;
    const char *old = csv_cell(csv, row->roster_row, in->grade);
    if (strcmp(s->status, "not graded") == 0 ||
        (in->changeable < csv->columns && strcasecmp(csv_cell(csv, row->roster_row, in->changeable), "No") == 0))
        return old;
    double most = in->kind == ROSTER_CANVAS && in->possible > 0 ? atof(csv_cell(csv, in->possible, in->grade))
                  : in->maximum < csv->columns                  ? atof(csv_cell(csv, row->roster_row, in->maximum))
                                                                : 0.0;
    double share = s->points_max > 0.0 ? s->points / s->points_max : 0.0;
    snprintf(text, size, "%.2f", most > 0.0 ? share * most : s->points);
    return text;
}

static void write_line(FILE *stream, const Table *table, size_t row, const char *grade)
{
    const Csv *csv = &table->roster.csv;
    const Grades *in = &table->grades;
    bool first = true;
    for (size_t c = 0; c < csv->columns; c++) {
        if (in->kind == ROSTER_CANVAS && c > in->section && c != in->grade)
            continue; // Canvas would take what stands there for a change
        csv_write(stream, c == in->grade ? grade : csv_cell(csv, row, c), first);
        first = false;
    }
    fputc('\n', stream);
}

void grades_write(FILE *stream, const Table *table)
{
    const Csv *csv = &table->roster.csv;
    const Grades *in = &table->grades;
    char grade[40];
    fputs(csv->marked ? MARK : "", stream);
    write_line(stream, table, 0, csv_cell(csv, 0, in->grade));
    if (in->possible > 0)
        write_line(stream, table, in->possible, csv_cell(csv, in->possible, in->grade));
    for (size_t i = 0; i < table->count; i++) {
        const TableRow *row = &table->rows[i];
        if (row->roster_row > 0)
            write_line(stream, table, row->roster_row, grade_of(table, row, grade, sizeof grade));
    }
}
