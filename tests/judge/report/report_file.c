// report.json: its fields, and what must hold between them. The judge writes it; it is read strictly, since points are at
// stake and anybody may have written it.
#include "judge/report/fields.h"
#include "base/file.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define FORMAT      "photonlab report 2"
#define MOST_BYTES  (64u << 20)
#define MOST_TEXT   4000  // bytes of a sentence
#define MOST_OUTPUT 32768 // of what a step printed
#define MOST_STEPS  1000
#define MOST_STAGES 99
#define MOST_CHECKS 100
#define MOST_BINS   1000
#define MOST_POINTS 1e9
#define MOST_TIME   1e9 // s
#define MOST_CASES  1e9

// A row for each field, called as its member.
#define FIELD(type, member, kind, low, high) {#member, kind, offsetof(type, member), low, high, 0, NULL}
#define TEXT(type, member)                   FIELD(type, member, FIELD_TEXT, 0, MOST_TEXT)
#define MAYBE(type, member)                  FIELD(type, member, FIELD_MAYBE, 0, 0)
#define OBJECT(type, member, shape)          {#member, FIELD_OBJECT, offsetof(type, member), 0, 0, 0, shape}
#define LIST(type, member, kind, most, counted, shape)                                                                 \
    {#member, kind, offsetof(type, member), 0, most, offsetof(type, counted), shape}
#define SHAPE(type, name, check)                                                                                       \
    static const Shape name##_shape = {sizeof(type), name##_fields, FIELD_COUNT(name##_fields), check}

static const Field picture_fields[] = {FIELD(ReportPicture, yours, FIELD_PATH, 1, MOST_TEXT),
                                       FIELD(ReportPicture, reference, FIELD_PATH, 1, MOST_TEXT),
                                       MAYBE(ReportPicture, T),
                                       MAYBE(ReportPicture, T_threshold),
                                       MAYBE(ReportPicture, V),
                                       MAYBE(ReportPicture, V_threshold)};
SHAPE(ReportPicture, picture, NULL);

static void check_histogram(const void *object, const char *path, Error *error)
{
    const ReportHistogram *histogram = object;
    if (histogram->expected_bins != histogram->bins || histogram->bins == 0)
        error_set(error, "report.json: %s: expected as many observed as expected numbers; found %zu and %zu", path,
                  histogram->bins, histogram->expected_bins);
}

static const Field histogram_fields[] = {TEXT(ReportHistogram, title), MAYBE(ReportHistogram, low),
                                         MAYBE(ReportHistogram, high),
                                         LIST(ReportHistogram, observed, FIELD_VALUES, MOST_BINS, bins, NULL),
                                         LIST(ReportHistogram, expected, FIELD_VALUES, MOST_BINS, expected_bins, NULL)};
SHAPE(ReportHistogram, histogram, check_histogram);

static const Field check_fields[] = {TEXT(ReportCheck, name),
                                     TEXT(ReportCheck, title),
                                     TEXT(ReportCheck, kind),
                                     FIELD(ReportCheck, status, FIELD_STATUS, 0, 0),
                                     TEXT(ReportCheck, message),
                                     MAYBE(ReportCheck, p),
                                     MAYBE(ReportCheck, threshold),
                                     FIELD(ReportCheck, failing_case, FIELD_WHOLE, -1, MOST_CASES),
                                     OBJECT(ReportCheck, histogram, &histogram_shape),
                                     OBJECT(ReportCheck, picture, &picture_shape)};
SHAPE(ReportCheck, check, NULL);

static void check_step(const void *object, const char *path, Error *error)
{
    const ReportStep *step = object;
    bool good = *step->id != '\0'; // it becomes part of links and names
    for (const char *c = step->id; *c; c++)
        good = good && (isalnum((unsigned char)*c) || *c == '.' || *c == '_' || *c == '-');
    if (!good)
        error_set(error, "report.json: %s.id: expected a number like 2.1; found \"%s\"", path, step->id);
    if (step->points > step->points_max)
        error_set(error, "report.json: %s.points: expected at most %g; found %g", path, step->points_max, step->points);
}

static const Field step_fields[] = {TEXT(ReportStep, id),
                                    TEXT(ReportStep, symbol),
                                    TEXT(ReportStep, title),
                                    FIELD(ReportStep, stage, FIELD_WHOLE, 1, MOST_STAGES),
                                    TEXT(ReportStep, chapter),
                                    FIELD(ReportStep, status, FIELD_STATUS, 0, 0),
                                    FIELD(ReportStep, points, FIELD_NUMBER, 0, MOST_POINTS),
                                    FIELD(ReportStep, points_max, FIELD_NUMBER, 0, MOST_POINTS),
                                    FIELD(ReportStep, hidden, FIELD_TRUTH, 0, 0),
                                    TEXT(ReportStep, due),
                                    TEXT(ReportStep, message),
                                    TEXT(ReportStep, where),
                                    TEXT(ReportStep, mistake),
                                    TEXT(ReportStep, looks_like),
                                    FIELD(ReportStep, output, FIELD_TEXT, 0, MOST_OUTPUT),
                                    FIELD(ReportStep, seconds, FIELD_NUMBER, 0, MOST_TIME),
                                    LIST(ReportStep, checks, FIELD_LIST, MOST_CHECKS, check_count, &check_shape)};
SHAPE(ReportStep, step, check_step);

static const Field scatter_fields[] = {FIELD(ReportScatter, stage, FIELD_WHOLE, 1, MOST_STAGES),
                                       FIELD(ReportScatter, status, FIELD_STATUS, 0, 0),
                                       TEXT(ReportScatter, message),
                                       TEXT(ReportScatter, steps),
                                       MAYBE(ReportScatter, p),
                                       MAYBE(ReportScatter, threshold),
                                       FIELD(ReportScatter, picture, FIELD_PATH, 0, MOST_TEXT),
                                       TEXT(ReportScatter, picture_message),
                                       FIELD(ReportScatter, seconds, FIELD_NUMBER, 0, MOST_TIME)};
SHAPE(ReportScatter, scatter, NULL);

#define COUNTS              7 // where those rows begin
#define COUNT(name, status) {name, FIELD_WHOLE, offsetof(Report, counts[status]), 0, MOST_STEPS, 0, NULL}
static const Field report_fields[] = {TEXT(Report, format),
                                      TEXT(Report, submission),
                                      FIELD(Report, credit, FIELD_TRUTH, 0, 0),
                                      TEXT(Report, sandbox),
                                      FIELD(Report, seconds, FIELD_NUMBER, 0, MOST_TIME),
                                      FIELD(Report, points, FIELD_NUMBER, 0, MOST_POINTS),
                                      FIELD(Report, points_max, FIELD_NUMBER, 0, MOST_POINTS),
                                      [COUNTS + STATUS_PASS] = COUNT("passed", STATUS_PASS),
                                      [COUNTS + STATUS_FAIL] = COUNT("failed", STATUS_FAIL),
                                      [COUNTS + STATUS_ERROR] = COUNT("errors", STATUS_ERROR),
                                      [COUNTS + STATUS_TODO] = COUNT("not_started", STATUS_TODO),
                                      LIST(Report, steps, FIELD_LIST, MOST_STEPS, step_count, &step_shape),
                                      LIST(Report, scatters, FIELD_LIST, MOST_STAGES, scatter_count, &scatter_shape)};

// The judge counted, too: a disagreement means that one of us is wrong, and points are at stake.
static void check_report(const void *object, const char *path, Error *error)
{
    const Report *report = object;
    (void)path;
    for (size_t i = 1; i < report->scatter_count; i++)
        if (report->scatters[i].stage <= report->scatters[i - 1].stage)
            error_set(error, "report.json: scatters[%zu].stage: expected one more than %d; found %d", i,
                      report->scatters[i - 1].stage, report->scatters[i].stage);
    ReportSums sums = report_sums(report, true, 0);
    for (int i = 0; i < STATUS_SKIP; i++)
        if (report->counts[i] != (int)sums.of[i])
            error_set(error, "report.json: %s is %d, but %zu steps have the status %s", report_fields[COUNTS + i].name,
                      report->counts[i], sums.of[i], status_table[i].name);
    if (fabs(report->points - sums.points) > 0.005)
        error_set(error, "report.json: points is %g, but the steps' points add up to %g", report->points, sums.points);
    if (report->points_max < sums.points_max - 0.005)
        error_set(error, "report.json: points_max is %g, but the steps' add up to %g", report->points_max,
                  sums.points_max);
}

SHAPE(Report, report, check_report);

typedef struct Kept {
    struct Kept *next;
    double bytes[]; // aligned for all that is kept
} Kept;

void *report_keep(Report *report, size_t size)
{
    Kept *kept = calloc(1, sizeof *kept + size);
    if (!kept) {
        fprintf(stderr, "report: no memory\n");
        exit(1);
    }
    kept->next = report->kept;
    report->kept = kept;
    return kept->bytes;
}

void report_free(Report *report)
{
    for (Kept *kept = report->kept; kept;) {
        Kept *next = kept->next;
        free(kept);
        kept = next;
    }
    report->kept = NULL;
}

bool report_write(Report *report, Error *error)
{
    report->format = FORMAT;
    ReportSums sums = report_sums(report, true, 0);
    report->points = sums.points;
    report->points_max = sums.points_max;
    for (int i = 0; i < STATUSES; i++)
        report->counts[i] = (int)sums.of[i];
    json_t *whole = fields_write(&report_shape, report);
    char *bytes = json_dumps(whole, JSON_INDENT(1) | JSON_REAL_PRECISION(9));
    FileWriter writer;
    char path[MOST_PATH];
    report_path(report, "report.json", path);
    bool ok = bytes ? file_write_begin(&writer, path, error) : error_set(error, "%s: cannot be put together", path);
    if (ok) {
        fprintf(writer.stream, "%s\n", bytes);
        ok = file_write_end(&writer, true, error);
    }
    free(bytes);
    json_decref(whole);
    return ok;
}

bool report_read(Report *report, const char *directory, Error *error)
{
    *report = (Report){.directory = directory};
    size_t size;
    char path[MOST_PATH];
    char *bytes = file_read(report_path(report, "report.json", path), MOST_BYTES, &size, error);
    if (!bytes)
        return false;
    json_error_t wrong;
    json_t *whole = json_loadb(bytes, size, JSON_REJECT_DUPLICATES | JSON_ALLOW_NUL, &wrong);
    free(bytes);
    if (!whole)
        return error_set(error, "%s:%d:%d: %s", path, wrong.line, wrong.column, wrong.text);
    const char *format = json_string_value(json_object_get(whole, "format"));
    if (!json_is_object(whole))
        error_set(error, "%s: expected an object", path);
    else if (!format || strcmp(format, FORMAT) != 0)
        error_set(error, "report.json: format: expected \"" FORMAT "\"; found \"%s\"", format ? format : "");
    bool ok = !*error->message && fields_read(&report_shape, whole, "", report, report, error);
    json_decref(whole);
    return ok;
}
