// The parts of the program `judge`.
#pragma once

#include "base/command_line.h"
#include "judge/report/report.h"
#include "judge/scatter/scatter.h"

#define EXIT_FAILS    1
#define EXIT_UNGRADED 3

typedef struct {
    GradeOptions grade;
    const char *step, *report, *points;
    int stage, jobs, scatters;
    bool credit, strict, features, verbose, lines;
} Arguments;

// 0; or, all said, the exit code or HELP_SHOWN.
int arguments_parse(int count, char **arguments, Arguments *a);

// The sandbox that there is, and what it must not show, which is closed to others where a user of its own runs the code. False: none, and
// for credit there has to be one; it has said so.
bool choose_sandbox(Arguments *a);

// All steps of a stage together; not where one step alone is asked for. Fills STAGE_COUNT of them, zeroed before.
void stages_grade(const Arguments *a, const StepResult *results, int count, StageResult *stages);

// Compiles the steps and prints a line per stage and salt: how often right code is called wrong, and which mistakes are
// seen. Returns the exit code.
int stages_measure(const Arguments *a, StepResult *results, int count);

// Writes report->directory/report.json, of which the other reports are made (judge/report/), and the pictures below it. The report
// holds directory, submission, sandbox, credit and seconds. `stages`: see print_results.
bool report_json_write(Report *report, const StepResult *results, int count, const StageResult *stages, Error *error);

// What the person at the terminal reads. The stages are STAGE_COUNT, each with its number, or 0 where none was asked for.
void print_results(const StepResult *results, int count, const StageResult *stages, bool verbose);
void print_lines_of_steps(const StepResult *results, int count); // as --lines says
// A line a step for the table of known mistakes: STEP STATUS NAME:value:error …, NAME the check's, once for each of its features.
void print_features(const StepResult *results, int count);

// ---- terminal.c: as wide as the terminal is, in colour where there is one, and without what would upset it

#define MOST_LINES 20 // of what a step printed

typedef struct {
    int width; // columns
    bool colour;
} Terminal;

Terminal terminal_find(void);

// An escape sequence, where colours are seen.
void terminal_paint(const Terminal *terminal, const char *code);

// Columns that the text takes: characters, but those that sit on the one before.
int terminal_columns(const char *text, size_t size);

// A copy without what is no text, to be freed; without memory for it the program ends.
char *terminal_clean(const char *text);

// Prints what is formatted like this, painted so, broken at blanks where a line is full. A word longer than a line stays whole: it
// may be a path to copy.
#define PLAIN ""
#define BOLD  "\033[1m"
#define DIM   "\033[2m"
void print_wrapped(const Terminal *terminal, const char *paint, const char *format, ...) PRINTF_LIKE(3, 4);

// Lines as they stand, since a compiler's point at columns: the first `before`, and with them the last that MOST_LINES has room
// for.
void print_lines(const char *text, size_t before);
