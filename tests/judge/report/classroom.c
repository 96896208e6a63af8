// GitHub Classroom's result: base64 of JSON, on one line, as its grading reporter takes it from a runner.
#include "report.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

// Classroom knows three statuses.
static const char *status_of(Status status)
{
    if (status == STATUS_PASS)
        return "pass";
    return status == STATUS_ERROR ? "error" : "fail";
}

static json_t *test_of(const Report *report, const ReportStep *step)
{
    char name[8200];
    snprintf(name, sizeof name, "%s %s", step->id, step->title);
    const char *message = *step->message ? step->message : status_table[step->status].words;
    return json_pack("{s:s, s:s, s:f, s:s}", "name", name, "status", status_of(step->status), "score",
                     report->credit ? step->points : 0.0, "message", step->status == STATUS_PASS ? "" : message);
}

static json_t *compose(const Report *report)
{
    ReportSums all = report_sums(report, true), seen = report_sums(report, false);
    json_t *tests = json_array();
    for (size_t i = 0; i < report->step_count; i++)
        if (!report->steps[i].hidden)
            json_array_append_new(tests, test_of(report, &report->steps[i]));
    if (seen.hidden > 0) // students see this list: hidden steps are one entry without words
        json_array_append_new(tests, json_pack("{s:s, s:s, s:f, s:s}", "name", "Hidden steps", "status",
                                               seen.hidden_points < seen.hidden_points_max ? "fail" : "pass", "score",
                                               report->credit ? seen.hidden_points : 0.0, "message", ""));
    const char *status = "pass";
    if (!report->credit || all.of[STATUS_ERROR] > 0)
        status = "error";
    else if (all.of[STATUS_PASS] < all.steps)
        status = "fail";
    return json_pack("{s:i, s:s, s:f, s:o}", "version", 1, "status", status, "max_score", all.points_max, "tests",
                     tests);
}

bool report_classroom(const Report *report, FILE *stream, Error *error)
{
    json_t *whole = compose(report);
    char *text = whole ? json_dumps(whole, JSON_COMPACT | JSON_REAL_PRECISION(10)) : NULL;
    json_decref(whole);
    if (!text)
        return error_set(error, "classroom.txt: cannot be made");
    text_base64(stream, (unsigned char *)text, strlen(text));
    fputc('\n', stream);
    free(text);
    return true;
}
