// Gradescope's results.json: a test per step. Gradescope itself keeps hidden ones from the student, and adds up the
// scores.
#include "report.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

#define MOST_OUTPUT 8192

static const char *visibility_of(const ReportStep *step)
{
    if (!step->hidden)
        return "visible";
    return *step->due ? "after_due_date" : "hidden";
}

static json_t *test_of(const Report *report, const ReportStep *step, const char *name, const char *number,
                       const char *mistake, const char *words)
{
    char tag[32];
    snprintf(tag, sizeof tag, "stage %d", step->stage);
    return json_pack("{s:f, s:f, s:s, s:s, s:s, s:s, s:s, s:[s], s:s, s:{s:s, s:s, s:f}}", "score",
                     report->credit ? step->points : 0.0, "max_score", step->points_max,      //
                     "status", step->status == STATUS_PASS ? "passed" : "failed",             //
                     "name", name, "number", number, "output", words,                         //
                     "output_format", "text", "tags", tag, "visibility", visibility_of(step), //
                     "extra_data", "status", status_table[step->status].name, "mistake", mistake, "seconds",
                     step->seconds);
}

static json_t *test_of_step(const Report *report, const ReportStep *step)
{
    char name[8200];
    snprintf(name, sizeof name, "%s %s", step->id, step->title);
    char *words = words_of_step(step, MOST_OUTPUT);
    json_t *test = test_of(report, step, name, step->id, step->mistake, words ? words : "");
    free(words);
    return test;
}

// Worth nothing, as the steps are; Gradescope shows it all the same.
static json_t *test_of_scatter(const Report *report, const ReportScatter *scatter)
{
    char name[60], title[32], words[5000];
    ReportStep step = report_scatter_step(scatter, title);
    snprintf(name, sizeof name, "Scatter %s", title);
    words_of_scatter(scatter, words, sizeof words);
    return test_of(report, &step, name, "", "", words);
}

bool report_gradescope(const Report *report, FILE *stream, Error *error)
{
    ReportSums sums = report_sums(report, false, 0);
    char summary[400];
    snprintf(summary, sizeof summary, "%s%zu passed, %zu failed, %zu with an error, %zu not started%s",
             report->credit ? "" : "NOT FOR CREDIT: the code ran without a sandbox, so every score is 0.\n",
             sums.of[STATUS_PASS], sums.of[STATUS_FAIL], sums.of[STATUS_ERROR], sums.of[STATUS_TODO],
             sums.hidden ? "; hidden steps are graded, too" : "");
    json_t *tests = json_array();
    for (size_t i = 0; i < report->step_count; i++)
        json_array_append_new(tests, test_of_step(report, &report->steps[i]));
    for (size_t i = 0; i < report->scatter_count; i++)
        json_array_append_new(tests, test_of_scatter(report, &report->scatters[i]));
    json_t *whole =
        json_pack("{s:f, s:s, s:s, s:s, s:s, s:o}", "execution_time", report->seconds, "output", summary,
                  "output_format", "text", "visibility", "visible", "stdout_visibility", "hidden", "tests", tests);
    if (whole && report->step_count == 0)
        json_object_set_new(whole, "score", json_real(0.0)); // without tests there must be a score
    bool good = whole && json_array_size(tests) == report->step_count + report->scatter_count &&
                json_dumpf(whole, stream, JSON_INDENT(2) | JSON_REAL_PRECISION(10)) == 0;
    json_decref(whole);
    fputc('\n', stream);
    return good || error_set(error, "gradescope/results.json: cannot be made");
}
