// TAP version 14: what is not started is "not ok … # TODO", which no harness counts as a failure.
#include "report.h"

#include <stdlib.h>
#include <string.h>

#define MOST_OUTPUT 8192 // bytes of what a step printed: Perl's parser gives up at lines of 64 KB

// A description or a reason: # and \ would mean something, and a line end would begin a new test.
static void write_plain(FILE *stream, const char *text)
{
    for (; *text; text++) {
        if (*text == '#' || *text == '\\')
            fputc('\\', stream);
        fputc(*text == '\n' || *text == '\t' ? ' ' : *text, stream);
    }
}

static void write_field(FILE *stream, const char *name, const char *text)
{
    if (!*text)
        return;
    fprintf(stream, "  %s: ", name);
    text_quoted(stream, text);
    fputc('\n', stream);
}

static void write_checks(const ReportStep *step, FILE *stream)
{
    if (step->check_count > 0)
        fputs("  checks:\n", stream);
    for (size_t i = 0; i < step->check_count; i++) {
        const ReportCheck *check = &step->checks[i];
        fputs("    - title: ", stream);
        text_quoted(stream, check->title);
        fprintf(stream, "\n      status: %s\n", status_table[check->status].name);
    }
}

static void write_details(const ReportStep *step, FILE *stream)
{
    char points[40], most[40];
    fputs("  ---\n", stream);
    write_field(stream, "message", step->message);
    fprintf(stream, "  severity: %s\n  points: %s\n  points_max: %s\n  seconds: %.3f\n",
            status_table[step->status].name, text_points(step->points, points, sizeof points),
            text_points(step->points_max, most, sizeof most), step->seconds);
    write_field(stream, "where", step->where);
    write_field(stream, "mistake", step->mistake);
    write_field(stream, "looks_like", step->looks_like);
    write_field(stream, "chapter", step->chapter);
    write_checks(step, stream);
    char *output = text_clean(step->output, strlen(step->output), MOST_OUTPUT);
    write_field(stream, "output", output ? output : "");
    free(output);
    fputs("  ...\n", stream);
}

static void write_title(const ReportStep *step, size_t number, FILE *stream)
{
    bool wrong = step->status != STATUS_PASS && step->status != STATUS_SKIP;
    fprintf(stream, "%s %zu - ", wrong ? "not ok" : "ok", number);
    write_plain(stream, step->id);
    fputc(' ', stream);
    write_plain(stream, step->title);
    if (step->status == STATUS_TODO || step->status == STATUS_SKIP) {
        fputs(step->status == STATUS_TODO ? " # TODO " : " # SKIP ", stream);
        write_plain(stream, *step->message ? step->message : status_table[step->status].words);
    }
    fputc('\n', stream);
}

static void write_scatter(const ReportScatter *scatter, size_t number, FILE *stream)
{
    char title[32];
    ReportStep step = report_scatter_step(scatter, title);
    write_title(&step, number, stream);
    fputs("  ---\n", stream);
    write_field(stream, "message", scatter->message);
    fprintf(stream, "  severity: %s\n  seconds: %.3f\n", status_table[scatter->status].name, scatter->seconds);
    write_field(stream, "steps", scatter->steps);
    fputs("  ...\n", stream);
}

bool report_tap(const Report *report, FILE *stream, Error *error)
{
    (void)error;
    ReportSums sums = report_sums(report, report->teacher, 0);
    fprintf(stream, "TAP version 14\n1..%zu%s\n", sums.steps + report->scatter_count,
            sums.steps ? "" : " # SKIP no step was graded");
    if (sums.hidden > 0)
        fprintf(stream, "# %zu hidden step%s graded, too\n", sums.hidden, sums.hidden == 1 ? " is" : "s are");
    size_t number = 0;
    for (const ReportStep *step = NULL; (step = report_next(report, step));) {
        write_title(step, ++number, stream);
        write_details(step, stream);
    }
    for (size_t i = 0; i < report->scatter_count; i++)
        write_scatter(&report->scatters[i], ++number, stream);
    return true;
}
