// index.html: one file without scripts that tells first how it stands and what to do next, then each step. It is
// well-formed XML, too, which the tests use.
#include "report.h"

#include <string.h>

static void write_points(double points, double points_max, FILE *stream)
{
    char got[40], most[40];
    fprintf(stream, "<b>%s</b> of %s points", text_points(points, got, sizeof got),
            text_points(points_max, most, sizeof most));
}

// A square a step, by stage, each leading to its step.
static void write_strip(const Report *report, FILE *stream)
{
    int stage = 0;
    fputs("<nav class=\"strip\" aria-label=\"steps\">", stream);
    for (const ReportStep *step = NULL; (step = report_next(report, step));) {
        if (stage != 0 && stage != step->stage)
            fputs("<span class=\"gap\"></span>", stream);
        stage = step->stage;
        const StatusInfo *status = &status_table[step->status];
        text_put(stream, "<a class=\"%s\" href=\"#step-%s\" title=\"%s: %s\"><i>%s</i>%s</a>", status->name, step->id,
                 step->title, status->words, status->mark, step->id);
    }
    fputs("</nav>\n", stream);
}

static void write_counts(const ReportSums *sums, FILE *stream)
{
    fputs("<p class=\"counts\">", stream);
    for (int i = 0; i < STATUSES; i++)
        if (sums->of[i] > 0 || i <= STATUS_FAIL)
            fprintf(stream, "<span class=\"%s\"><i>%s</i> %zu %s</span> ", status_table[i].name, status_table[i].mark,
                    sums->of[i], status_table[i].words);
    fputs("</p>\n", stream);
}

// The first step that is wrong; if none is, the first that is not started. NULL: all is done.
static const ReportStep *next_step(const Report *report)
{
    const ReportStep *open = NULL;
    for (const ReportStep *step = NULL; (step = report_next(report, step));) {
        if (status_is_wrong(step->status))
            return step;
        if (step->status == STATUS_TODO && !open)
            open = step;
    }
    return open;
}

// All steps are right alone, and what they make together is not.
static const ReportScatter *next_scatter(const Report *report, const ReportStep *step)
{
    for (size_t i = 0; i < report->scatter_count && !(step && status_is_wrong(step->status)); i++)
        if (status_is_wrong(report->scatters[i].status))
            return &report->scatters[i];
    return NULL;
}

static void write_next(const Report *report, const ReportSums *sums, FILE *stream)
{
    const ReportStep *step = next_step(report);
    const ReportScatter *scatter = next_scatter(report, step);
    if (scatter) {
        fprintf(stream, "<p class=\"next %s\"><b>Next:</b> <a href=\"#scatter-%d\">the scatter of stage %d</a></p>\n",
                status_table[scatter->status].name, scatter->stage, scatter->stage);
        return;
    }
    if (!step) {
        if (sums->of[STATUS_PASS] > 0 && sums->of[STATUS_PASS] == sums->steps)
            fputs("<p class=\"next pass\"><b>All done.</b> Every step passes.</p>\n", stream);
        return;
    }
    text_put(stream, "<p class=\"next %s\"><b>Next:</b> <a href=\"#step-%s\">%s %s</a>%s%s</p>\n",
             status_table[step->status].name, step->id, step->id, step->title,
             *step->looks_like ? " — looks like " : "", step->looks_like);
}

static void write_head(const Report *report, const ReportSums *sums, FILE *stream)
{
    text_put(stream,
             "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
             "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
             "<meta name=\"color-scheme\" content=\"light dark\"/>\n<title>photonlab · %s</title>\n<style>\n",
             report->submission);
    for (size_t i = 0; report_style[i]; i++)
        fputs(report_style[i], stream);
    text_put(stream, "</style>\n</head>\n<body>\n<main>\n<header>\n<p class=\"name\">photonlab · %s</p>\n<h1>",
             report->submission);
    double most = sums->hidden ? sums->points_max : report->points_max;
    write_points(sums->points, most, stream);
    fputs("</h1>\n", stream);
    write_counts(sums, stream);
    write_strip(report, stream);
    write_next(report, sums, stream);
    if (sums->hidden > 0) {
        char got[40];
        fprintf(stream, "<p class=\"note\">%zu hidden step%s graded, too; worth %s more points.</p>\n", sums->hidden,
                sums->hidden == 1 ? " is" : "s are", text_points(sums->hidden_points_max, got, sizeof got));
    }
    if (!report->credit)
        fputs("<p class=\"note warning\">Not for credit: the code ran without a sandbox.</p>\n", stream);
    fputs("</header>\n", stream);
}

// Before its first step.
static void write_stage_title(const Report *report, const ReportStep *step, FILE *stream)
{
    ReportSums sums = report_sums(report, report->teacher, step->stage);
    fprintf(stream, "<h2>Stage %d", step->stage);
    // A chapter's file is named for its stage: 2_glossy_lobe.html.
    const char *word = strchr(step->chapter, '_'), *end = strstr(step->chapter, ".html");
    if (word && end && word < end) {
        fputs(" · ", stream);
        for (const char *c = word + 1; c < end; c++)
            text_put(stream, "%s", (char[]){*c == '_' ? ' ' : *c, '\0'});
    }
    fputs("<span class=\"points\">", stream);
    write_points(sums.points, sums.points_max, stream);
    fputs("</span></h2>\n", stream);
}

static void write_scatter(const Report *report, int stage, FILE *stream)
{
    const ReportScatter *scatter = report_scatter(report, stage);
    if (scatter)
        html_scatter(report, scatter, stream);
}

bool report_html(const Report *report, FILE *stream, Error *error)
{
    (void)error;
    ReportSums sums = report_sums(report, report->teacher, 0);
    write_head(report, &sums, stream);
    int stage = 0;
    for (const ReportStep *step = NULL; (step = report_next(report, step));) {
        if (step->stage != stage)
            write_scatter(report, stage, stream);
        if (step->stage != stage)
            write_stage_title(report, step, stream);
        stage = step->stage;
        html_step(report, step, stream);
    }
    write_scatter(report, stage, stream);
    if (report->finale)
        text_put(
            stream,
            "<h2>Finale</h2>\n<p><a href=\"%s\"><img style=\"width:100%%\" alt=\"the course's picture by these steps, framed\" "
            "src=\"%s\"/></a></p>\n",
            report->finale, report->finale);
    fprintf(stream, "<footer>Graded in %.1f s; sandbox: ", report->seconds);
    text_put(stream, "%s.</footer>\n</main>\n</body>\n</html>\n", report->sandbox);
    return true;
}
