// build/report DIR: from DIR/report.json, which the judge wrote, to everything that people and graders read.
//
//   report.json ──▶ report_file.c ──▶ Report ──▶ html.c          index.html
//                                            ├─▶ junit.c         junit.xml
//                                            ├─▶ tap.c           report.tap
//                                            ├─▶ gradescope.c    gradescope/results.json
//                                            └─▶ prairielearn.c  prairielearn/results.json
//
// A writer decides nothing: statuses and points are the judge's. What came from a student is text, and harmless from
// report_file.c on (see text_clean); each writer escapes it once more for its own format. README.md describes report.json.
#pragma once

#include "base/error.h"
#include "judge/report/status.h"
#include "judge/report/text.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

// The members are report.json's fields. Numbers that are null there are NaN here.
typedef struct {
    const char *title; // NULL: there is no histogram
    double low, high;
    const double *observed, *expected;
    size_t bins, expected_bins; // as many
} ReportHistogram;

typedef struct {
    const char *yours, *reference; // paths below the report's directory; NULL: there is no picture
    double T, T_threshold;         // the largest deviation of a patch, in the reference's standard deviations
    double V, V_threshold;         // how much noisier or smoother, as a logarithm
} ReportPicture;

typedef struct {
    const char *name, *title, *kind, *message;
    Status status;
    double p, threshold;
    int failing_case; // within the check; −1: none in particular
    ReportHistogram histogram;
    ReportPicture picture;
} ReportCheck;

typedef struct {
    const char *id, *symbol, *title, *chapter, *message, *where, *mistake, *looks_like, *output;
    const char *due; // "2026-12-01"; empty: none
    int stage;
    Status status;
    bool hidden;
    double points, points_max, seconds;
    const ReportCheck *checks;
    size_t check_count;
} ReportStep;

// All of a stage's steps at work together. There is one for each stage in which steps played, and no other.
typedef struct {
    int stage;
    Status status;
    const char *message, *steps;           // "2.1 2.4": who played
    const char *picture, *picture_message; // a PNG, path below the report's directory; empty: none, and why not
    double p, threshold, seconds;
} ReportScatter;

typedef struct {
    const char *directory;
    const char *format, *submission, *sandbox;
    bool credit; // false: the student's code ran without a sandbox, so no grader may take the points
    double seconds, points, points_max;
    int counts[STATUSES]; // of steps; but for STATUS_SKIP
    const ReportStep *steps;
    size_t step_count;
    const ReportScatter *scatters; // by stage
    size_t scatter_count;

    bool teacher;       // show hidden steps, too
    const char *notes;  // put before a chapter to make a link of it; NULL: no links
    const char *finale; // a picture that the page ends with; NULL: none
    void *kept;         // memory of all the above
} Report;

// Writes the report to its directory, points and counts summed from the steps: what the judge does.
bool report_write(Report *report, Error *error);
// Reads and checks DIR/report.json. False with "file: steps[2].points: what is wrong" otherwise. Free it either way.
bool report_read(Report *report, const char *directory, Error *error);
void report_free(Report *report);
void *report_keep(Report *report, size_t size); // zeroed memory that report_free frees; ends the program when short

// What one reader may see: the sums leave hidden steps out, unless they are the teacher's. Of one stage, or, 0, of all.
typedef struct {
    size_t of[STATUSES], hidden, steps;
    double points, points_max, hidden_points, hidden_points_max, seconds;
} ReportSums;
ReportSums report_sums(const Report *report, bool teacher, int stage);
// The first step that is shown behind `step`, or, NULL, of all; NULL: no more.
const ReportStep *report_next(const Report *report, const ReportStep *step);

// directory/name; returns `path`.
#define MOST_PATH 8200
char *report_path(const Report *report, const char *name, char path[MOST_PATH]);

const ReportScatter *report_scatter(const Report *report, int stage); // NULL: there is none
// The scatter as a step worth nothing, "scatter of stage 2". `title` is a part of it.
ReportStep report_scatter_step(const ReportScatter *scatter, char title[32]);

// A writer of one file. False with an error when there is no memory; a full disk shows when the file is closed.
typedef bool ReportWriter(const Report *report, FILE *stream, Error *error);
ReportWriter report_html, report_junit, report_tap, report_gradescope, report_prairielearn;

// ---- words.c

// A check's statistic against its threshold, as a sentence; empty when there is none.
void words_of_check(const ReportCheck *check, char *words, size_t size);
void words_of_scatter(const ReportScatter *scatter, char *words, size_t size); // of several lines
// A step as plain text of several lines, with at most `most_output` bytes of what it printed; the caller frees it.
char *words_of_step(const ReportStep *step, size_t most_output);

// ---- inside the HTML writer

extern const char *const report_style[]; // NULL last
void html_step(const Report *report, const ReportStep *step, FILE *stream);
void html_histogram(const ReportHistogram *histogram, FILE *stream);
void html_pictures(const Report *report, const ReportPicture *picture, FILE *stream);
void html_png(const Report *report, const char *name, const char *alt, FILE *stream); // or a sentence why not
void html_scatter(const Report *report, const ReportScatter *scatter, FILE *stream);
