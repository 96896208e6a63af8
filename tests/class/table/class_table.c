// The program: reads what is told, orders the rows, writes all files.
#include "class/table/class_table.h"
#include "base/command_line.h"
#include "base/file.h"
#include "judge/report/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char help[] =
    "usage: class_table [flags] [OUT LIST]\n"
    "\n"
    "Makes OUT/class.csv, index.html and lecture.html of the reports in OUT. LIST holds the submissions' names, each with a 0\n"
    "byte behind it. Without OUT it says what the course's steps are worth by the points table, a line each.\n"
    "\n"
    "  --points FILE    what steps are worth, and when they are due (tests/judge/points.txt)\n"
    "  --roster FILE    a CSV with a row for each student\n"
    "  --column NAME    its column that has the submissions' names; unset: the one that has most of them\n"
    "  --format NAME    moodle or canvas: OUT/NAME.csv, the roster with grades, as the course system takes it\n"
    "  --grade NAME     its column for the grades; unset: the only one there is\n"
    "  --earlier FILE   class.csv of a class graded before: what was handed in in time then counts where it is late now\n"
    "  --notes PATH     where the course notes lie, seen from OUT\n"
    "  --pictures PATH  the folder with the gallery's pictures\n";

bool stage_counts(const Table *table, int stage)
{
    double points = 0.0;
    for (size_t i = 0; i < STEP_COUNT; i++)
        points += step_table[i].stage == stage ? table->points.points[i] : 0.0;
    return points > 0.0;
}

static void leave_out_stages(const Table *table, Student *student)
{
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (!stage_counts(table, step_table[i].stage))
            memset(&student->steps[i], 0, sizeof student->steps[i]);
}

// The roster's rows first, then whoever is not in it.
static void order_rows(Table *table, Student *students, size_t count, Student *absent)
{
    const Roster *roster = &table->roster;
    double total = 0.0;
    for (size_t i = 0; i < STEP_COUNT; i++)
        total += table->points.points[i];
    for (size_t r = 1; r < roster->csv.rows; r++) {
        if (!roster_is_student(roster, r))
            continue;
        absent[r] = (Student){
            .name = "", .status = "no submission", .message = "no submission", .in_roster = true, .points_max = total};
        table->rows[table->count++] = (TableRow){roster->of[r] ? &students[roster->of[r] - 1] : &absent[r], r};
    }
    for (size_t i = 0; i < count; i++) {
        students[i].points_max = total;
        if (!students[i].in_roster)
            table->rows[table->count++] = (TableRow){&students[i], 0};
    }
}

static void print_course(const PointsTable *points)
{
    char text[40];
    for (size_t i = 0; i < step_count_of(points->stages); i++)
        printf("%s %s\n", step_table[i].id, text_points(points->points[i], text, sizeof text));
}

static void write_head(FILE *stream, const Table *table, const Csv *roster)
{
    for (size_t c = 0; roster && c < roster->columns; c++)
        csv_write(stream, csv_cell(roster, 0, c), c == 0);
    fprintf(stream, "%ssubmission,status%s,points,points_max", roster ? "," : "", roster ? ",in_roster" : "");
    for (int i = 1; i <= STAGE_COUNT; i++)
        if (stage_counts(table, i))
            fprintf(stream, ",stage_%d", i);
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (stage_counts(table, step_table[i].stage))
            fprintf(stream, ",%s", step_table[i].id);
    fputs(
        ",passed,failed,errors,not_started,skipped,submitted,days_late,late_penalty,likely_mistakes,message,seconds\n",
        stream);
}

static void write_points(FILE *stream, double points)
{
    fprintf(stream, ",%.10g", round(1e4 * points) / 1e4);
}

static void write_row(FILE *stream, const Table *table, const Csv *roster, const TableRow *row)
{
    const Student *s = row->student;
    char mistakes[2048], time[40];
    for (size_t c = 0; roster && c < roster->columns; c++)
        csv_write(stream, row->roster_row ? csv_cell(roster, row->roster_row, c) : "", c == 0);
    csv_write_text(stream, s->name, !roster);
    csv_write(stream, s->status, false);
    if (roster)
        csv_write(stream, s->in_roster ? "yes" : "no", false);
    write_points(stream, s->points);
    write_points(stream, s->points_max);
    for (int i = 1; i <= STAGE_COUNT; i++)
        if (stage_counts(table, i))
            write_points(stream, s->stage_points[i - 1]);
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (stage_counts(table, step_table[i].stage))
            write_points(stream, s->steps[i].points);
    for (size_t i = 0; i < STATUSES; i++)
        fprintf(stream, ",%zu", student_count(s, status_table[i].name));
    strftime(time, sizeof time, "%Y-%m-%d %H:%M", localtime(&s->submitted));
    csv_write(stream, s->submitted ? time : "", false);
    fprintf(stream, ",%.0f", s->late);
    write_points(stream, s->penalty);
    student_mistakes(s, mistakes, sizeof mistakes);
    csv_write_text(stream, mistakes, false);
    csv_write_text(stream, s->message, false);
    fprintf(stream, ",%.1f\n", s->seconds);
}

static void write_csv(FILE *stream, const Table *table)
{
    const Csv *roster = table->roster.csv.rows > 0 ? &table->roster.csv : NULL;
    write_head(stream, table, roster);
    for (size_t r = 0; r < table->count; r++)
        write_row(stream, table, roster, &table->rows[r]);
}

static bool write_to(const char *directory, const char *name, TableWriter *write, const Table *table, Error *error)
{
    char path[4200];
    FileWriter writer;
    snprintf(path, sizeof path, "%.4000s/%s", directory, name);
    if (!file_write_begin(&writer, path, error))
        return false;
    write(writer.stream, table);
    return file_write_end(&writer, true, error);
}

static Student *read_students(const char *directory, const char *names, size_t size, size_t *count)
{
    *count = 0;
    for (size_t i = 0; i < size; i++)
        *count += names[i] == '\0';
    Student *students = calloc(*count + 1, sizeof *students);
    for (size_t i = 0; students && i < *count; i++, names += strlen(names) + 1)
        student_read(directory, names, &students[i]);
    return students;
}

typedef struct {
    const char *points, *roster, *column, *grade, *earlier, *notes, *pictures, *files[2];
    Choice format;
} Arguments;

static const char *const formats[] = {"plain", "moodle", "canvas", NULL}; // in the order of RosterKind

static bool write_all(const Arguments *a, const Table *table, Error *error)
{
    char name[40];
    snprintf(name, sizeof name, "%s.csv", formats[a->format.chosen]);
    return write_to(a->files[0], "class.csv", write_csv, table, error) &&
           write_to(a->files[0], "index.html", page_write, table, error) &&
           write_to(a->files[0], "lecture.html", lecture_write, table, error) &&
           (a->format.chosen == ROSTER_PLAIN || write_to(a->files[0], name, grades_write, table, error));
}

static bool run(const Arguments *a, Table *table, Error *error)
{
    size_t size, count = 0;
    RosterKind kind = (RosterKind)a->format.chosen;
    if (a->roster && !roster_read(a->roster, &table->roster, error))
        return false;
    if (kind != ROSTER_PLAIN && !grades_find(&table->roster, kind, a->grade, &table->grades, error))
        return false;
    char *names = file_read(a->files[1], 64u << 20, &size, error);
    Student *students = names ? read_students(a->files[0], names, size, &count) : NULL;
    Student *absent = calloc(table->roster.csv.rows + 1, sizeof *absent);
    table->rows = calloc(table->roster.csv.rows + count + 1, sizeof *table->rows);
    bool ok = names && ((students && absent && table->rows) || error_set(error, "no memory")) &&
              (!a->roster || roster_match(&table->roster, a->roster, a->column, students, count, error));
    for (size_t i = 0; ok && i < count; i++) {
        leave_out_stages(table, &students[i]);
        student_set_late(&students[i], &table->points, &table->earlier);
    }
    if (ok)
        order_rows(table, students, count, absent);
    ok = ok && write_all(a, table, error);
    free(absent);
    free(students);
    free(names);
    return ok;
}

int main(int count, char **arguments)
{
    Arguments a = {.format = {formats, ROSTER_PLAIN}};
    const Flag flags[] = {{"points", FLAG_TEXT, &a.points, 0, 0}, {"roster", FLAG_TEXT, &a.roster, 0, 0},
                          {"column", FLAG_TEXT, &a.column, 0, 0}, {"format", FLAG_CHOICE, &a.format, 0, 0},
                          {"grade", FLAG_TEXT, &a.grade, 0, 0},   {"earlier", FLAG_TEXT, &a.earlier, 0, 0},
                          {"notes", FLAG_TEXT, &a.notes, 0, 0},   {"pictures", FLAG_TEXT, &a.pictures, 0, 0}};
    int wrong = command_line_parse(&(CommandLine){"class_table", help, "OUT and LIST", flags, FLAG_COUNT(flags), 0, 2},
                                   count, arguments, a.files);
    if (wrong)
        return wrong == HELP_SHOWN ? 0 : wrong;
    Table table = {.notes = a.notes, .pictures = a.pictures};
    Error error = {""};
    bool ok = points_read(a.points ? a.points : "tests/judge/points.txt", &table.points, &error) &&
              (!a.earlier || csv_read(a.earlier, &table.earlier, &error)) && (!a.files[1] || run(&a, &table, &error));
    if (ok && !a.files[1])
        print_course(&table.points);
    free(table.rows);
    csv_free(&table.earlier);
    roster_free(&table.roster);
    if (!ok)
        fprintf(stderr, "class_table: %s\n", error.message);
    return ok ? 0 : 1;
}
