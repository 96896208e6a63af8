// report.json, strictly: every field must be there, none else, and the sums must agree with the steps.
#include "fields.h"
#include "base/file.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MOST_BYTES  (64u << 20)
#define MOST_TEXT   4000  // bytes of a sentence
#define MOST_OUTPUT 65536 // of what a step printed
#define MOST_STEPS  1000
#define MOST_STAGES 99
#define MOST_CHECKS 100
#define MOST_BINS   1000
#define MOST_POINTS 1e9

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

// Pictures lie below the report: a path that leads elsewhere would carry a file of this machine into the page.
static const char *read_path(Fields *fields, const char *name)
{
    const char *path = field_text(fields, name, MOST_TEXT);
    bool climbs = strcmp(path, "..") == 0 || strncmp(path, "../", 3) == 0 || strstr(path, "/../");
    if (fields_good(fields) && (path[0] == '\0' || path[0] == '/' || climbs))
        error_set(fields->error, "report.json: %s.%s: expected a path below the report's directory; found \"%s\"",
                  fields->path, name, path);
    return path;
}

static void read_picture(Fields *check, ReportPicture *picture)
{
    Fields fields;
    if (!field_object(check, "picture", &fields))
        return;
    *picture = (ReportPicture){.yours = read_path(&fields, "yours"),
                               .reference = read_path(&fields, "reference"),
                               .T = field_number_or_null(&fields, "T"),
                               .T_threshold = field_number_or_null(&fields, "T_threshold"),
                               .V = field_number_or_null(&fields, "V"),
                               .V_threshold = field_number_or_null(&fields, "V_threshold")};
    fields_end(&fields);
}

static void read_histogram(Fields *check, ReportHistogram *histogram)
{
    Fields fields;
    if (!field_object(check, "histogram", &fields))
        return;
    size_t expected;
    *histogram = (ReportHistogram){.title = field_text(&fields, "title", MOST_TEXT),
                                   .low = field_number_or_null(&fields, "low"),
                                   .high = field_number_or_null(&fields, "high")};
    histogram->observed = field_numbers(&fields, "observed", MOST_BINS, &histogram->bins);
    histogram->expected = field_numbers(&fields, "expected", MOST_BINS, &expected);
    if (fields_end(&fields) && (expected != histogram->bins || expected == 0))
        error_set(fields.error, "report.json: %s: expected as many observed as expected numbers; found %zu and %zu",
                  fields.path, histogram->bins, expected);
}

static void read_check(Fields *fields, ReportCheck *check)
{
    *check = (ReportCheck){.name = field_text(fields, "name", MOST_TEXT),
                           .title = field_text(fields, "title", MOST_TEXT),
                           .kind = field_text(fields, "kind", MOST_TEXT),
                           .status = field_status(fields, "status"),
                           .message = field_text(fields, "message", MOST_TEXT),
                           .p = field_number_or_null(fields, "p"),
                           .threshold = field_number_or_null(fields, "threshold"),
                           .failing_case = field_number(fields, "failing_case", -1, 1e15)};
    read_histogram(fields, &check->histogram);
    read_picture(fields, &check->picture);
    fields_end(fields);
}

// It becomes part of links and names.
static void check_id(Fields *fields, const char *id)
{
    bool good = *id != '\0';
    for (const char *c = id; *c; c++)
        good = good && (isalnum((unsigned char)*c) || *c == '.' || *c == '_' || *c == '-');
    if (!good)
        error_set(fields->error, "report.json: %s.id: expected a number like 2.1; found \"%s\"", fields->path, id);
}

static void read_checks(Fields *fields, ReportStep *step)
{
    const json_t *array = field_array(fields, "checks", MOST_CHECKS, &step->check_count);
    ReportCheck *checks = report_keep(fields->report, (step->check_count + 1) * sizeof *checks);
    for (size_t i = 0; i < step->check_count; i++) {
        Fields check = fields_of_element(fields, "checks", array, i);
        read_check(&check, &checks[i]);
    }
    step->checks = checks;
}

static void read_step(Fields *fields, ReportStep *step)
{
    *step = (ReportStep){.id = field_text(fields, "id", MOST_TEXT),
                         .symbol = field_text(fields, "symbol", MOST_TEXT),
                         .title = field_text(fields, "title", MOST_TEXT),
                         .stage = (int)field_number(fields, "stage", 1, 99),
                         .chapter = field_text(fields, "chapter", MOST_TEXT),
                         .status = field_status(fields, "status"),
                         .points = field_number(fields, "points", 0, MOST_POINTS),
                         .points_max = field_number(fields, "points_max", 0, MOST_POINTS),
                         .hidden = field_truth(fields, "hidden"),
                         .due = field_text(fields, "due", MOST_TEXT),
                         .message = field_text(fields, "message", MOST_TEXT),
                         .where = field_text(fields, "where", MOST_TEXT),
                         .mistake = field_text(fields, "mistake", MOST_TEXT),
                         .looks_like = field_text(fields, "looks_like", MOST_TEXT),
                         .output = field_text(fields, "output", MOST_OUTPUT),
                         .seconds = field_number(fields, "seconds", 0, 1e9)};
    read_checks(fields, step);
    if (!fields_end(fields))
        return;
    check_id(fields, step->id);
    if (step->points > step->points_max)
        error_set(fields->error, "report.json: %s.points: expected at most %g; found %g", fields->path,
                  step->points_max, step->points);
}

static void read_scatter(Fields *fields, ReportScatter *scatter)
{
    *scatter = (ReportScatter){.stage = (int)field_number(fields, "stage", 1, 99),
                               .status = field_status(fields, "status"),
                               .message = field_text(fields, "message", MOST_TEXT),
                               .steps = field_text(fields, "steps", MOST_TEXT),
                               .p = field_number_or_null(fields, "p"),
                               .threshold = field_number_or_null(fields, "threshold"),
                               .picture_message = field_text(fields, "picture_message", MOST_TEXT),
                               .seconds = field_number(fields, "seconds", 0, 1e9)};
    bool none = json_string_length(json_object_get(fields->object, "picture")) == 0;
    scatter->picture = none ? field_text(fields, "picture", 0) : read_path(fields, "picture");
    fields_end(fields);
}

static void read_scatters(Fields *fields)
{
    Report *report = fields->report;
    const json_t *array = field_array(fields, "scatters", MOST_STAGES, &report->scatter_count);
    ReportScatter *scatters = report_keep(report, (report->scatter_count + 1) * sizeof *scatters);
    for (size_t i = 0; i < report->scatter_count; i++) {
        Fields scatter = fields_of_element(fields, "scatters", array, i);
        read_scatter(&scatter, &scatters[i]);
        if (i > 0 && scatters[i].stage <= scatters[i - 1].stage)
            error_set(fields->error, "report.json: %s.stage: expected one more than %d; found %d", scatter.path,
                      scatters[i - 1].stage, scatters[i].stage);
    }
    report->scatters = scatters;
}

static void read_steps(Fields *fields)
{
    Report *report = fields->report;
    const json_t *array = field_array(fields, "steps", MOST_STEPS, &report->step_count);
    ReportStep *steps = report_keep(report, (report->step_count + 1) * sizeof *steps);
    for (size_t i = 0; i < report->step_count; i++) {
        Fields step = fields_of_element(fields, "steps", array, i);
        read_step(&step, &steps[i]);
    }
    report->steps = steps;
}

// The judge counted, too: a disagreement means that one of us is wrong, and points are at stake.
static void check_sums(Fields *fields, const double counts[STATUSES])
{
    ReportSums sums = report_sums(fields->report, true);
    for (int i = 0; i < STATUSES; i++)
        if (status_table[i].count && counts[i] != (double)sums.of[i])
            error_set(fields->error, "report.json: %s is %g, but %zu steps have the status %s", status_table[i].count,
                      counts[i], sums.of[i], status_table[i].name);
    if (fabs(fields->report->points - sums.points) > 0.005)
        error_set(fields->error, "report.json: points is %g, but the steps' points add up to %g",
                  fields->report->points, sums.points);
    if (fields->report->points_max < sums.points_max - 0.005)
        error_set(fields->error, "report.json: points_max is %g, but the steps' add up to %g",
                  fields->report->points_max, sums.points_max);
}

static void read_whole(Fields *fields)
{
    Report *report = fields->report;
    const char *format = field_text(fields, "format", MOST_TEXT);
    if (strcmp(format, "photonlab report 2") != 0)
        error_set(fields->error, "report.json: format: expected \"photonlab report 2\"; found \"%s\"", format);
    report->submission = field_text(fields, "submission", MOST_TEXT);
    report->credit = field_truth(fields, "credit");
    report->sandbox = field_text(fields, "sandbox", MOST_TEXT);
    report->seconds = field_number(fields, "seconds", 0, 1e9);
    report->points = field_number(fields, "points", 0, MOST_POINTS);
    report->points_max = field_number(fields, "points_max", 0, MOST_POINTS);
    double counts[STATUSES];
    for (int i = 0; i < STATUSES; i++)
        counts[i] = !status_table[i].count ? 0.0 : field_number(fields, status_table[i].count, 0, MOST_STEPS);
    read_steps(fields);
    read_scatters(fields);
    if (fields_end(fields))
        check_sums(fields, counts);
}

bool report_read(Report *report, const char *directory, Error *error)
{
    *report = (Report){.directory = directory};
    size_t length = strlen(directory) + 20, size;
    char *path = report_keep(report, length);
    snprintf(path, length, "%s/report.json", directory);
    char *bytes = file_read(path, MOST_BYTES, &size, error);
    if (!bytes)
        return false;
    json_error_t wrong;
    json_t *whole = json_loadb(bytes, size, JSON_REJECT_DUPLICATES | JSON_ALLOW_NUL, &wrong);
    free(bytes);
    if (!whole)
        return error_set(error, "%s:%d:%d: %s", path, wrong.line, wrong.column, wrong.text);
    Fields fields = {.report = report, .object = whole, .error = error};
    if (!json_is_object(whole))
        error_set(error, "%s: expected an object", path);
    else
        read_whole(&fields);
    json_decref(whole);
    return fields_good(&fields);
}
