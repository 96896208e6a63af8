// class_table: from the reports of a class to its table, its pages, and the file that a course system takes grades from.
//
//   reports ──▶ class_student.c ──▶ Student ──▶ class_late.c ──▶ order_rows ──▶ TableRow ──▶ class.csv      class_table.c
//   roster ───▶ class_csv.c ──▶ class_roster.c: whose is which ─────┘                   ├─▶ index.html     class_page.c
//                                                                                       ├─▶ lecture.html   class_lecture.c
//                                                                                       └─▶ canvas.csv …   class_grades.c
#pragma once

#include "base/error.h"
#include "judge/grade/points.h"
#include "judge/report/status.h"
#include "steps/steps.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <time.h>

typedef struct {
    char *bytes;          // what the cells point into
    char **cells;         // row after row
    size_t columns, rows; // with the header; short rows are filled up with ""
    bool marked;          // it began with a byte order mark
} Csv;

#define MARK "\xEF\xBB\xBF"
// Reads RFC 4180, with LF or CRLF, commas or (when the header has no comma) semicolons or tabs, with or without a byte
// order mark. Free it either way.
bool csv_read(const char *path, Csv *csv, Error *error);
const char *csv_cell(const Csv *csv, size_t row, size_t column);
bool csv_find(const Csv *csv, const char *title, size_t *column); // capital or not
void csv_write(FILE *stream, const char *cell, bool first);       // quoted where it must be
// For a text that a student had a hand in: a spreadsheet must not take it for a formula.
void csv_write_text(FILE *stream, const char *cell, bool first);
void csv_free(Csv *csv);

typedef struct {
    char status[8], mistake[64], said[400]; // the mistake's name, or ""; what went wrong in words, or ""
    double points, points_max;
    bool there, hidden;
} StudentStep;

typedef struct {
    const char *name;
    char message[6200];
    char status[32]; // "graded", "partly graded", "unreadable", "not graded" (why: message), "no submission"
    double seconds, points, points_max, stage_points[STAGE_COUNT];
    time_t submitted;     // 0: not known
    double late, penalty; // days, begun ones are whole, after the day of the stage that was due first; points taken off
    bool in_roster, has_page;
    StudentStep steps[STEP_COUNT]; // all empty where a step is not in the course
} Student;

void student_read(const char *directory, const char *name, Student *student);
size_t student_count(const Student *student, const char *status);
void student_mistakes(const Student *student, char *text, size_t size); // "2.1: uniform hemisphere; 3.2: …"
// Takes off what being late costs. `earlier`: class.csv of a class graded before; a stage that is late now has what it had there,
// if that is more. No columns: there was none.
void student_set_late(Student *student, const PointsTable *points, const Csv *earlier);

// Who is in the course, as a teacher wrote it down, or as a course system gives it out.
typedef enum { ROSTER_PLAIN, ROSTER_MOODLE, ROSTER_CANVAS } RosterKind;
typedef struct {
    Csv csv; // no rows: there is no roster
    RosterKind kind;
    size_t column; // the one that submissions are known by
    size_t *of;    // for each row the student's number and 1; 0: no submission
} Roster;

bool roster_read(const char *path, Roster *roster, Error *error);
bool roster_is_student(const Roster *roster, size_t row); // Canvas has rows of other kinds
// Finds the column that matches most submissions, or takes `wanted`; fills in `of` and in_roster, and submitted where a
// column tells it. False when nobody is in it. A warning to stderr when few are.
bool roster_match(Roster *roster, const char *path, const char *wanted, Student *students, size_t count, Error *error);
void roster_free(Roster *roster);

// Rows in the order of the table: the roster's, then those that are not in it.
typedef struct {
    const Student *student;
    size_t roster_row; // 0: none
} TableRow;

// Where grades go in a course system's file: columns; as many as there are: none.
typedef struct {
    RosterKind kind;
    size_t grade, maximum, changeable, section, feedback;
    size_t possible; // Canvas' row of the highest points; 0: none
} Grades;

typedef struct {
    Roster roster;
    Csv earlier; // no columns: there is none
    PointsTable points;
    Grades grades;
    TableRow *rows;
    size_t count;
    const char *notes,
        *pictures; // where the notes lie, seen from the pages, NULL: nowhere; a folder with the gallery's tiles
} Table;

// A step that went wrong in the same words for `count` of the rows from `who` on.
typedef struct {
    size_t step, count;
    const char *name, *said; // "pi_missing" or "", and the sentence
    const size_t *who;       // numbers of rows
} Mistake;
// The commonest first; memory of the caller's, with that of `who`. NULL: there is none, or no memory.
Mistake *mistakes_find(const Table *table, size_t *count, size_t **who);
bool mistake_has_tile(const Table *table, const Mistake *mistake, char *path, size_t size); // the picture's path
void mistake_write(FILE *stream, const Table *table, const Mistake *mistake);               // with a link to its tile

// Is there something to be had in it? What is not in the course (`stages 3`) is none of the table and the pages.
bool stage_counts(const Table *table, int stage);

typedef void TableWriter(FILE *stream, const Table *table);
TableWriter page_write, page_write_spread, lecture_write, grades_write;
// To be asked before anything is written: where in the roster do grades go? In `column`, or NULL: in the only one there is.
bool grades_find(const Roster *roster, RosterKind kind, const char *column, Grades *in, Error *error);

size_t count_rows(const Table *table, size_t step, Status status); // where the step came to this
void page_begin(FILE *stream, const char *title);                  // what both pages begin with, to their style
void page_link(FILE *stream, const char *path);                    // a path in a link
