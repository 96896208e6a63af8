// class_table: from the reports of a class to class.csv and index.html.
#ifndef PHOTONLAB_CLASS_TABLE_H
#define PHOTONLAB_CLASS_TABLE_H

#include "base/error.h"
#include "judge/report/status.h"
#include "steps/steps.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

typedef struct {
    char *bytes;          // what the cells point into
    char **cells;         // row after row
    size_t columns, rows; // with the header; short rows are filled up with ""
} Csv;

// Reads RFC 4180, with LF or CRLF, commas or (when the header has no comma) semicolons or tabs, with or without a byte
// order mark.
bool csv_read(const char *path, Csv *csv, Error *error);
const char *csv_cell(const Csv *csv, size_t row, size_t column);
void csv_write(FILE *stream, const char *cell, bool first); // quoted where it must be
// For a text that a student had a hand in: a spreadsheet must not take it for a formula.
void csv_write_text(FILE *stream, const char *cell, bool first);
void csv_free(Csv *csv);

typedef struct {
    const char *name;
    char message[6200];
    char status[32]; // "graded", "partly graded", "unreadable", "not graded" (why: message), "no submission"
    double seconds, points, points_max, stage_points[STAGE_COUNT];
    bool in_roster, has_page;
    struct {
        char status[8], mistake[64], looks_like[400]; // the mistake's name, and what students read
        double points;
        bool there;
    } steps[STEP_COUNT];
} Student;

void student_read(const char *directory, const char *name, Student *student);
size_t student_count(const Student *student, const char *status);
// The points that the table of points gives in all: the judge's report of nothing says so. Else the most that is found.
void student_set_total(const char *directory, Student *students, size_t count, Student *absent, size_t rows);
void student_mistakes(const Student *student, char *text, size_t size); // "2.1: uniform hemisphere; 3.2: …"

// Rows in the order of the table: the roster's, then those that are not in it.
typedef struct {
    const Student *student;
    size_t roster_row; // 0: none
} TableRow;

void table_write_csv(FILE *stream, const Csv *roster, const TableRow *rows, size_t count);
void page_write_spread(FILE *stream, const TableRow *rows, size_t count); // quartiles and histogram of points
void page_write(FILE *stream, const Csv *roster, const TableRow *rows, size_t count);

#endif
