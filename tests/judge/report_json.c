#include "report_json.h"
#include "base/file.h"
#include "report/text.h"

#include <errno.h>
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

// JSON has no NaN.
static json_t *number(double value)
{
    return isfinite(value) ? json_real(value) : json_null();
}

// Students' code prints what it likes.
#define MOST_TEXT 32768
static json_t *text(const char *from)
{
    char *clean = text_clean(from, strlen(from), MOST_TEXT);
    json_t *string = json_string(clean ? clean : "");
    free(clean);
    return string;
}

static json_t *numbers(const double *values, int count)
{
    json_t *array = json_array();
    for (int i = 0; i < count; i++)
        json_array_append_new(array, number(values[i]));
    return array;
}

static json_t *histogram(const Finding *finding)
{
    if (finding->bins == 0)
        return json_null();
    return json_pack("{s:o, s:o, s:o, s:o, s:o}", "title", text(finding->histogram_title), "low", number(finding->low),
                     "high", number(finding->high), "observed", numbers(finding->observed, finding->bins), "expected",
                     numbers(finding->expected, finding->bins));
}

static bool write_image(const Image *image, const char *directory, const char *id, const char *whose, char *name,
                        size_t size, Error *error)
{
    char path[4200];
    snprintf(name, size, "pictures/%s_%s.pfm", id, whose);
    snprintf(path, sizeof path, "%s/%s", directory, name);
    return image_write_pfm(image, path, error);
}

// A picture with values that are no numbers cannot be written; its message says so already.
static json_t *picture(const char *directory, const char *id, const Finding *finding)
{
    char yours[128], reference[128];
    Error ignored = {""};
    if (!finding->yours.pixels || !finding->reference.pixels ||
        !write_image(&finding->yours, directory, id, "yours", yours, sizeof yours, &ignored) ||
        !write_image(&finding->reference, directory, id, "reference", reference, sizeof reference, &ignored))
        return json_null();
    return json_pack("{s:s, s:s, s:o, s:o, s:o, s:o}", "yours", yours, "reference", reference, "T", number(finding->T),
                     "T_threshold", number(finding->T_threshold), "V", number(finding->V), "V_threshold",
                     number(finding->V_threshold));
}

static json_t *check_json(const char *directory, const char *id, const CheckResult *result)
{
    const Finding *f = &result->finding;
    bool failed = result->status == STATUS_FAIL;
    const char *message = !failed ? "" : f->failed ? f->message : f->p_message;
    bool has_p = f->tests > 0 && result->check->kind != CHECK_PICTURE && result->status != STATUS_SKIP;
    return json_pack("{s:s, s:s, s:s, s:s, s:o, s:o, s:o, s:I, s:o, s:o}", "name", result->check->name, "title",
                     result->check->title, "kind", check_kind_names[result->check->kind], "status",
                     status_table[result->status].name, "message", text(message), "p",
                     has_p ? number(f->p) : json_null(), "threshold", has_p ? number(result->threshold) : json_null(),
                     "failing_case", (json_int_t)f->failing_case, "histogram", histogram(f), "picture",
                     picture(directory, id, f));
}

static json_t *step_json(const char *directory, const StepResult *r)
{
    json_t *checks = json_array();
    for (int i = 0; i < r->check_count; i++)
        json_array_append_new(checks, check_json(directory, r->step->id, &r->checks[i]));
    return json_pack("{s:s, s:s, s:s, s:i, s:s, s:s, s:o, s:o, s:b, s:s, s:o, s:o, s:s, s:s, s:o, s:o, s:o}", "id",
                     r->step->id, "symbol", r->step->symbol, "title", r->step->title, "stage", r->step->stage,
                     "chapter", r->step->chapter, "status", status_table[r->status].name, "points", number(r->points),
                     "points_max", number(r->points_max), "hidden", r->hidden, "due", r->due, "message",
                     text(r->words.message), "where", text(r->words.where), "mistake", r->mistake, "looks_like",
                     r->looks_like, "output", text(r->words.output), "seconds", number(r->seconds), "checks", checks);
}

// A stage that could not be asked about, or has no step to play, has no line.
static json_t *scatters_json(const StageResult *stages)
{
    json_t *array = json_array();
    for (int i = 0; i < STAGE_COUNT; i++) {
        const StageResult *s = &stages[i];
        bool judged = s->tests > 0 && (s->status == STATUS_PASS || s->status == STATUS_FAIL);
        if (s->stage == 0 || s->status == STATUS_TODO)
            continue;
        json_array_append_new(array,
                              json_pack("{s:i, s:s, s:o, s:s, s:o, s:o, s:s, s:o, s:o}", "stage", s->stage, "status",
                                        status_table[s->status].name, "message", text(s->message), "steps", s->steps,
                                        "p", judged ? number(s->p) : json_null(), "threshold",
                                        judged ? number(s->threshold) : json_null(), "picture", s->picture,
                                        "picture_message", text(s->picture_message), "seconds", number(s->seconds)));
    }
    return array;
}

static json_t *report_json(const char *directory, const ReportHead *head, const StepResult *results, int count,
                           const StageResult *stages)
{
    double points = 0.0, points_max = 0.0;
    int of[STATUSES] = {0};
    json_t *steps_array = json_array();
    for (int i = 0; i < count; i++) {
        points += results[i].points;
        points_max += results[i].points_max;
        of[results[i].status]++;
        json_array_append_new(steps_array, step_json(directory, &results[i]));
    }
    json_t *report = json_pack("{s:s, s:o, s:b, s:s, s:o, s:o, s:o}", "format", "photonlab report 2", "submission",
                               text(head->submission), "credit", head->credit, "sandbox", head->sandbox, "seconds",
                               number(head->seconds), "points", number(points), "points_max", number(points_max));
    for (int i = 0; i < STATUSES; i++)
        if (status_table[i].count)
            json_object_set_new(report, status_table[i].count, json_integer(of[i]));
    json_object_set_new(report, "steps", steps_array);
    json_object_set_new(report, "scatters", scatters_json(stages));
    return report;
}

static bool make_directory(const char *path, Error *error)
{
    if (mkdir(path, 0755) != 0 && errno != EEXIST)
        return error_set(error, "%s: %s", path, strerror(errno));
    return true;
}

bool report_json_write(const char *directory, const ReportHead *head, const StepResult *results, int count,
                       const StageResult *stages, Error *error)
{
    char path[4200];
    snprintf(path, sizeof path, "%s/pictures", directory);
    if (!make_directory(directory, error) || !make_directory(path, error))
        return false;
    json_t *report = report_json(directory, head, results, count, stages);
    char *bytes = report ? json_dumps(report, JSON_INDENT(1) | JSON_REAL_PRECISION(9)) : NULL;
    snprintf(path, sizeof path, "%s/report.json", directory);
    FileWriter writer;
    bool ok = bytes ? file_write_begin(&writer, path, error) : error_set(error, "%s: cannot be put together", path);
    if (ok) {
        fprintf(writer.stream, "%s\n", bytes);
        ok = file_write_end(&writer, true, error);
    }
    free(bytes);
    json_decref(report);
    return ok;
}
