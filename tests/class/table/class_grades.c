// The file that Moodle or Canvas takes grades from: theirs, with the grades filled in.
#include "base/text.h"
#include "class/table/class_table.h"

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
    *in = (Grades){kind, csv->columns, csv->columns, csv->columns, csv->columns, 0};
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
    return column || csv_find(csv, "Grade", &in->grade);
}

// Points as a share of what the course system takes for the most; what could not be graded stays as it was.
static const char *grade_of(const Table *table, const TableRow *row, char *text, size_t size)
{
    const Csv *csv = &table->roster.csv;
    const Grades *in = &table->grades;
    const Student *s = row->student;
    const char *old = csv_cell(csv, row->roster_row, in->grade);
    bool excused = in->kind == ROSTER_CANVAS && (strcasecmp(old, "EX") == 0 || strcmp(old, "N/A") == 0);
    if (strcmp(s->status, "not graded") == 0 || excused ||
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
