#include "judge/judge.h"

#include <errno.h>
#include <math.h>
#include <string.h>
#include <sys/stat.h>

static const char *write_image(Report *report, const Image *image, const char *id, const char *whose)
{
    char path[MOST_PATH], *name = report_keep(report, 128);
    Error ignored = {""};
    snprintf(name, 128, "pictures/%s_%s.pfm", id, whose);
    return image_write_pfm(image, report_path(report, name, path), &ignored) ? name : NULL;
}

// A picture with values that are no numbers cannot be written; its message says so already.
static ReportPicture picture_of(Report *report, const char *id, const Finding *f)
{
    ReportPicture none = {.yours = NULL},
                  picture = {.T = f->T, .T_threshold = f->T_threshold, .V = f->V, .V_threshold = f->V_threshold};
    if (!f->yours.pixels || !f->reference.pixels)
        return none;
    picture.yours = write_image(report, &f->yours, id, "yours");
    picture.reference = picture.yours ? write_image(report, &f->reference, id, "reference") : NULL;
    return picture.reference ? picture : none;
}

static ReportCheck check_of(Report *report, const char *id, const CheckResult *result)
{
    const Finding *f = &result->finding;
    bool has_p = f->tests > 0 && result->check->kind != CHECK_PICTURE && result->status != STATUS_SKIP;
    ReportCheck check = {.name = result->check->name,
                         .title = result->check->title,
                         .kind = check_kind_names[result->check->kind],
                         .status = result->status,
                         .message = result->status != STATUS_FAIL ? ""
                                    : f->failed                   ? f->message
                                                                  : f->p_message,
                         .p = has_p ? f->p : (double)NAN,
                         .threshold = has_p ? result->threshold : (double)NAN,
                         .failing_case = (int)f->failing_case,
                         .picture = picture_of(report, id, f)};
    size_t bins = (size_t)f->bins;
    if (bins > 0)
        check.histogram = (ReportHistogram){f->histogram_title, f->low, f->high, f->observed, f->expected, bins, bins};
    return check;
}

static ReportStep step_of(Report *report, const StepResult *r)
{
    ReportCheck *checks = report_keep(report, MOST_CHECKS * sizeof *checks);
    for (int i = 0; i < r->check_count; i++)
        checks[i] = check_of(report, r->step->id, &r->checks[i]);
    return (ReportStep){.id = r->step->id,
                        .symbol = r->step->symbol,
                        .title = r->step->title,
                        .stage = r->step->stage,
                        .chapter = r->step->chapter,
                        .status = r->status,
                        .points = r->points,
                        .points_max = r->points_max,
                        .hidden = r->hidden,
                        .due = r->due,
                        .message = r->words.message,
                        .where = r->words.where,
                        .mistake = r->mistake,
                        .looks_like = r->looks_like,
                        .output = r->words.output,
                        .seconds = r->seconds,
                        .checks = checks,
                        .check_count = (size_t)r->check_count};
}

static ReportScatter scatter_of(const StageResult *s)
{
    bool judged = s->tests > 0 && (s->status == STATUS_PASS || s->status == STATUS_FAIL);
    return (ReportScatter){.stage = s->stage,
                           .status = s->status,
                           .message = s->message,
                           .steps = s->steps,
                           .p = judged ? s->p : (double)NAN,
                           .threshold = judged ? s->threshold : (double)NAN,
                           .picture = s->picture,
                           .picture_message = s->picture_message,
                           .seconds = s->seconds};
}

static bool make_directory(const char *path, Error *error)
{
    if (mkdir(path, 0755) != 0 && errno != EEXIST)
        return error_set(error, "%s: %s", path, strerror(errno));
    return true;
}

bool report_json_write(Report *report, const StepResult *results, int count, const StageResult *stages, Error *error)
{
    char path[MOST_PATH];
    if (!make_directory(report->directory, error) || !make_directory(report_path(report, "pictures", path), error))
        return false;
    ReportStep *list = report_keep(report, STEP_COUNT * sizeof *list);
    ReportScatter *scatters = report_keep(report, STAGE_COUNT * sizeof *scatters);
    for (int i = 0; i < count; i++)
        list[i] = step_of(report, &results[i]);
    for (int i = 0; i < STAGE_COUNT; i++) // one that could not be asked about, or has no step to play, has no line
        if (stages[i].stage > 0 && stages[i].status != STATUS_TODO)
            scatters[report->scatter_count++] = scatter_of(&stages[i]);
    report->steps = list;
    report->step_count = (size_t)count;
    report->scatters = scatters;
    bool ok = report_write(report, error);
    report_free(report);
    return ok;
}
