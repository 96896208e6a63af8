// class_table OUT LIST [ROSTER [COLUMN]]: OUT/class.csv and OUT/index.html from the reports in OUT. LIST holds the
// submissions' names, each with a 0 byte behind it. The roster's column COLUMN (unset: the first called id, login,
// email or name) is compared with the names.
#include "class/table/class_table.h"
#include "base/file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static bool find_column(const Csv *roster, const char *wanted, size_t *column, Error *error)
{
    static const char *const usual[] = {"id", "login", "email", "name"};
    for (size_t c = 0; c < roster->columns; c++) {
        const char *title = csv_cell(roster, 0, c);
        bool found = wanted && strcasecmp(title, wanted) == 0;
        for (size_t i = 0; i < sizeof usual / sizeof *usual && !wanted; i++)
            found = found || strcasecmp(title, usual[i]) == 0;
        if (found) {
            *column = c;
            return true;
        }
    }
    return error_set(error, "the roster has no column `%s`", wanted ? wanted : "id, login, email or name");
}

// Course systems put more behind the name: Doe Jane_123456_assignsubmission_file.
static bool is_same(const char *cell, const char *name, bool exactly)
{
    size_t length = exactly ? strlen(name) : strcspn(name, "_");
    return *cell && strlen(cell) == length && strncasecmp(cell, name, length) == 0;
}

static Student *find_student(Student *students, size_t count, const char *cell)
{
    for (int exactly = 1; exactly >= 0; exactly--)
        for (size_t i = 0; i < count; i++)
            if (is_same(cell, students[i].name, exactly) && (exactly || !students[i].in_roster))
                return &students[i];
    return NULL;
}

// The roster's rows first, then whoever is not in it.
static size_t order_rows(const Csv *roster, size_t column, Student *students, size_t count, Student *absent,
                         TableRow *rows)
{
    size_t used = 0;
    for (size_t r = 1; roster && r < roster->rows; r++) {
        Student *student = find_student(students, count, csv_cell(roster, r, column));
        if (student)
            student->in_roster = true;
        else
            absent[r] = (Student){.name = "", .status = "no submission", .message = "no submission", .in_roster = true};
        rows[used++] = (TableRow){student ? student : &absent[r], r};
    }
    for (size_t i = 0; i < count; i++)
        if (!roster || !students[i].in_roster)
            rows[used++] = (TableRow){&students[i], 0};
    return used;
}

static void write_head(FILE *stream, const Csv *roster)
{
    for (size_t c = 0; roster && c < roster->columns; c++)
        csv_write(stream, csv_cell(roster, 0, c), c == 0);
    fprintf(stream, "%ssubmission,status%s,points,points_max", roster ? "," : "", roster ? ",in_roster" : "");
    for (int i = 1; i <= STAGE_COUNT; i++)
        fprintf(stream, ",stage_%d", i);
    for (size_t i = 0; i < STEP_COUNT; i++)
        fprintf(stream, ",%s", step_table[i].id);
    fputs(",passed,failed,errors,not_started,skipped,likely_mistakes,message,seconds\n", stream);
}

static void write_points(FILE *stream, double points)
{
    fprintf(stream, ",%.10g", round(1e4 * points) / 1e4);
}

static void write_row(FILE *stream, const Csv *roster, const TableRow *row)
{
    const Student *s = row->student;
    char mistakes[2048];
    for (size_t c = 0; roster && c < roster->columns; c++)
        csv_write(stream, row->roster_row ? csv_cell(roster, row->roster_row, c) : "", c == 0);
    csv_write_text(stream, s->name, !roster);
    csv_write(stream, s->status, false);
    if (roster)
        csv_write(stream, s->in_roster ? "yes" : "no", false);
    write_points(stream, s->points);
    write_points(stream, s->points_max);
    for (int i = 0; i < STAGE_COUNT; i++)
        write_points(stream, s->stage_points[i]);
    for (size_t i = 0; i < STEP_COUNT; i++)
        write_points(stream, s->steps[i].points);
    for (size_t i = 0; i < STATUSES; i++)
        fprintf(stream, ",%zu", student_count(s, status_table[i].name));
    student_mistakes(s, mistakes, sizeof mistakes);
    csv_write_text(stream, mistakes, false);
    csv_write_text(stream, s->message, false);
    fprintf(stream, ",%.1f\n", s->seconds);
}

void table_write_csv(FILE *stream, const Csv *roster, const TableRow *rows, size_t count)
{
    write_head(stream, roster);
    for (size_t r = 0; r < count; r++)
        write_row(stream, roster, &rows[r]);
}

typedef void Writer(FILE *stream, const Csv *roster, const TableRow *rows, size_t count);

static bool write_to(const char *directory, const char *name, Writer *write, const Csv *roster, const TableRow *rows,
                     size_t count, Error *error)
{
    char path[4200];
    FileWriter writer;
    snprintf(path, sizeof path, "%.4000s/%s", directory, name);
    if (!file_write_begin(&writer, path, error))
        return false;
    write(writer.stream, roster, rows, count);
    return file_write_end(&writer, true, error);
}

static size_t read_students(const char *directory, const char *names, size_t size, Student **students)
{
    size_t count = 0;
    for (size_t i = 0; i < size; i++)
        count += names[i] == '\0';
    *students = calloc(count + 1, sizeof **students);
    for (size_t i = 0; *students && i < count; i++, names += strlen(names) + 1)
        student_read(directory, names, &(*students)[i]);
    return *students ? count : 0;
}

static bool run(char **arguments, int count, Error *error)
{
    Csv roster = {NULL, NULL, 0, 0};
    size_t column = 0, size;
    bool ok = count < 4 || (csv_read(arguments[3], &roster, error) &&
                            find_column(&roster, count > 4 ? arguments[4] : NULL, &column, error));
    char *names = ok ? file_read(arguments[2], 64u << 20, &size, error) : NULL;
    Student *students = NULL;
    size_t submissions = names ? read_students(arguments[1], names, size, &students) : 0;
    Student *absent = calloc(roster.rows + 2, sizeof *absent);
    TableRow *rows = calloc(roster.rows + submissions + 1, sizeof *rows);
    const Csv *used = count > 3 ? &roster : NULL;
    ok = names && ((students && absent && rows) || error_set(error, "no memory"));
    size_t lines = ok ? order_rows(used, column, students, submissions, absent, rows) : 0;
    if (ok)
        student_set_total(arguments[1], students, submissions, absent, roster.rows + 1);
    ok = ok && write_to(arguments[1], "class.csv", table_write_csv, used, rows, lines, error) &&
         write_to(arguments[1], "index.html", page_write, used, rows, lines, error);
    free(rows);
    free(absent);
    free(students);
    free(names);
    csv_free(&roster);
    return ok;
}

int main(int count, char **arguments)
{
    if (count < 3 || count > 5) {
        fprintf(stderr, "usage: class_table OUT LIST [ROSTER [COLUMN]]\n");
        return 2;
    }
    Error error = {""};
    if (run(arguments, count, &error))
        return 0;
    fprintf(stderr, "class_table: %s\n", error.message);
    return 1;
}
