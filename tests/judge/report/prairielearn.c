// PrairieLearn's results.json. It takes at most 1 MB: when that is exceeded, what the steps printed is cut shorter.
// Hidden steps are one entry, which has points but no words, since students see all entries.
#include "report.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

#define MOST_BYTES 1000000

static json_t *entry(const char *name, const char *symbol, double points, double points_max, const char *message,
                     const char *output)
{
    return json_pack("{s:s, s:s, s:f, s:f, s:s, s:s}", "name", name, "description", symbol, "points", points,
                     "max_points", points_max, "message", message, "output", output);
}

static json_t *entry_of(const ReportStep *step, size_t most_output)
{
    char name[8200];
    const StatusInfo *status = &status_table[step->status];
    snprintf(name, sizeof name, "%s %s %s", status->mark, step->id, step->title);
    char *words = words_of_step(step, most_output);
    json_t *test = entry(name, step->symbol, step->points, step->points_max,
                         *step->message ? step->message : status->words, words ? words : "");
    free(words);
    return test;
}

static json_t *entry_of_scatter(const ReportScatter *scatter)
{
    char name[80], words[5000];
    const StatusInfo *status = &status_table[scatter->status];
    snprintf(name, sizeof name, "%s Scatter of stage %d", status->mark, scatter->stage);
    words_of_scatter(scatter, words, sizeof words);
    return entry(name, "", 0.0, 0.0, *scatter->message ? scatter->message : status->words, words);
}

// The whole as text, which the caller frees. NULL: no memory.
static char *compose(const Report *report, size_t most_output)
{
    ReportSums all = report_sums(report, true, 0), seen = report_sums(report, false, 0);
    json_t *tests = json_array();
    for (size_t i = 0; i < report->step_count; i++)
        if (!report->steps[i].hidden)
            json_array_append_new(tests, entry_of(&report->steps[i], most_output));
    for (size_t i = 0; i < report->scatter_count; i++)
        json_array_append_new(tests, entry_of_scatter(&report->scatters[i]));
    if (seen.hidden > 0)
        json_array_append_new(tests, entry("Hidden steps", "", seen.hidden_points, seen.hidden_points_max, "", ""));
    // Of the steps graded, not of the whole course: a question may ask for one stage.
    double score = all.points_max > 0.0 ? all.points / all.points_max : 0.0;
    char message[300];
    snprintf(message, sizeof message, "%s%zu passed, %zu failed, %zu with an error, %zu not started",
             report->credit ? "" : "Not gradable: the code ran without a sandbox. ", seen.of[STATUS_PASS],
             seen.of[STATUS_FAIL], seen.of[STATUS_ERROR], seen.of[STATUS_TODO]);
    json_t *whole = json_pack("{s:b, s:f, s:s, s:s, s:o}", "gradable", report->credit, "score",
                              score > 1.0 ? 1.0 : score, "message", message, "output", "", "tests", tests);
    char *text = whole ? json_dumps(whole, JSON_INDENT(1) | JSON_REAL_PRECISION(10)) : NULL;
    json_decref(whole);
    return text;
}

bool report_prairielearn(const Report *report, FILE *stream, Error *error)
{
    for (size_t most_output = 16384;; most_output /= 4) {
        char *text = compose(report, most_output);
        if (!text)
            return error_set(error, "prairielearn/results.json: cannot be made");
        size_t size = strlen(text);
        if (size < MOST_BYTES)
            fprintf(stream, "%s\n", text);
        free(text);
        if (size < MOST_BYTES)
            return true;
        if (most_output == 0)
            return error_set(error, "prairielearn/results.json: %zu bytes without any output; expected at most %d",
                             size, MOST_BYTES);
    }
}
