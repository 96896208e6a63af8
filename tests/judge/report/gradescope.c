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

static json_t *test_of(const Report *report, const ReportStep *step)
{
    char name[8200], tag[32];
    snprintf(name, sizeof name, "%s %s", step->id, step->title);
    snprintf(tag, sizeof tag, "stage %d", step->stage);
    char *words = words_of_step(step, MOST_OUTPUT);
    json_t *test = json_pack("{s:f, s:f, s:s, s:s, s:s, s:s, s:s, s:[s], s:s, s:{s:s, s:s, s:f}}", "score",
                             report->credit ? step->points : 0.0, "max_score", step->points_max,      //
                             "status", step->status == STATUS_PASS ? "passed" : "failed",             //
                             "name", name, "number", step->id, "output", words ? words : "",          //
                             "output_format", "text", "tags", tag, "visibility", visibility_of(step), //
                             "extra_data", "status", status_table[step->status].name, "mistake", step->mistake,
                             "seconds", step->seconds);
    free(words);
    return test;
}

// Worth nothing, as the steps are; Gradescope shows it all the same.
static json_t *scatter_of(const ReportScatter *scatter)
{
    char name[60], tag[32], words[5000];
    snprintf(name, sizeof name, "Scatter of stage %d", scatter->stage);
    snprintf(tag, sizeof tag, "stage %d", scatter->stage);
    words_of_scatter(scatter, words, sizeof words);
    return json_pack("{s:f, s:f, s:s, s:s, s:s, s:s, s:s, s:[s], s:s, s:{s:s, s:s, s:f}}", "score", 0.0, "max_score",
                     0.0,                                                                                        //
                     "status", scatter->status == STATUS_PASS ? "passed" : "failed", "name", name, "number", "", //
                     "output", words, "output_format", "text", "tags", tag, "visibility", "visible", "extra_data",
                     "status", status_table[scatter->status].name, "mistake", "", "seconds", scatter->seconds);
}

bool report_gradescope(const Report *report, FILE *stream, Error *error)
{
    ReportSums sums = report_sums(report, false);
    char summary[400];
    snprintf(summary, sizeof summary, "%s%zu passed, %zu failed, %zu with an error, %zu not started%s",
             report->credit ? "" : "NOT FOR CREDIT: the code ran without a sandbox, so every score is 0.\n",
             sums.of[STATUS_PASS], sums.of[STATUS_FAIL], sums.of[STATUS_ERROR], sums.of[STATUS_TODO],
             sums.hidden ? "; hidden steps are graded, too" : "");
    json_t *tests = json_array();
    for (size_t i = 0; i < report->step_count; i++)
        json_array_append_new(tests, test_of(report, &report->steps[i]));
    for (size_t i = 0; i < report->scatter_count; i++)
        json_array_append_new(tests, scatter_of(&report->scatters[i]));
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
