// JUnit XML as Jenkins, GitLab and GitHub's actions read it: a suite per stage, a test case per step and one for its scatter. Checked against
// junit.xsd beside.
#include "report.h"

#include <stdlib.h>
#include <string.h>

// The sums of one stage; stage 0: of all.
static ReportSums sums_of_stage(const Report *report, int stage)
{
    ReportSums sums = {.hidden = 0};
    for (size_t i = 0; i < report->step_count; i++) {
        const ReportStep *step = &report->steps[i];
        if (!report_shows(report, step) || (stage && step->stage != stage))
            continue;
        sums.steps++;
        sums.of[step->status]++;
        sums.seconds += step->seconds;
    }
    for (size_t i = 0; i < report->scatter_count; i++) {
        const ReportScatter *scatter = &report->scatters[i];
        if (stage && scatter->stage != stage)
            continue;
        sums.steps++;
        sums.of[scatter->status]++;
        sums.seconds += scatter->seconds;
    }
    return sums;
}

static void write_counts(const ReportSums *sums, FILE *stream)
{
    fprintf(stream, " tests=\"%zu\" failures=\"%zu\" errors=\"%zu\" skipped=\"%zu\" time=\"%.3f\">\n", sums->steps,
            sums->of[STATUS_FAIL], sums->of[STATUS_ERROR], sums->of[STATUS_TODO] + sums->of[STATUS_SKIP],
            sums->seconds);
}

static void write_result(const ReportStep *step, FILE *stream)
{
    static const char *const elements[] = {NULL, "failure", "error", "skipped", "skipped"};
    const char *element = elements[step->status];
    if (!element)
        return;
    fprintf(stream, "      <%s message=\"", element);
    text_markup(stream, *step->message ? step->message : status_table[step->status].words);
    fputc('"', stream);
    if (strcmp(element, "skipped") == 0) {
        fputs("/>\n", stream);
        return;
    }
    fputs(" type=\"", stream);
    text_markup(stream, *step->mistake ? step->mistake : status_table[step->status].name);
    fputs("\">", stream);
    char *words = words_of_step(step, 0);
    text_markup(stream, words ? words : "");
    free(words);
    fprintf(stream, "</%s>\n", element);
}

static void write_case(const ReportStep *step, FILE *stream)
{
    fprintf(stream, "    <testcase classname=\"photonlab.stage_%d\" name=\"", step->stage);
    text_markup(stream, step->id);
    fputc(' ', stream);
    text_markup(stream, step->title);
    fprintf(stream, "\" time=\"%.3f\">\n", step->seconds);
    write_result(step, stream);
    if (*step->output) {
        fputs("      <system-out>", stream);
        text_markup(stream, step->output);
        fputs("</system-out>\n", stream);
    }
    fputs("    </testcase>\n", stream);
}

static void write_scatter(const ReportScatter *scatter, FILE *stream)
{
    char words[5000];
    fprintf(stream, "    <testcase classname=\"photonlab.stage_%d\" name=\"scatter of stage %d\" time=\"%.3f\">\n",
            scatter->stage, scatter->stage, scatter->seconds);
    if (status_is_wrong(scatter->status)) {
        const char *element = scatter->status == STATUS_FAIL ? "failure" : "error";
        fprintf(stream, "      <%s message=\"", element);
        text_markup(stream, scatter->message);
        fprintf(stream, "\" type=\"scatter\">");
        words_of_scatter(scatter, words, sizeof words);
        text_markup(stream, words);
        fprintf(stream, "</%s>\n", element);
    } else if (scatter->status != STATUS_PASS) {
        fputs("      <skipped message=\"", stream);
        text_markup(stream, scatter->message);
        fputs("\"/>\n", stream);
    }
    fputs("    </testcase>\n", stream);
}

static void write_stage(const Report *report, int stage, FILE *stream)
{
    ReportSums sums = sums_of_stage(report, stage);
    if (sums.steps == 0)
        return;
    fprintf(stream, "  <testsuite name=\"stage %d\"", stage);
    write_counts(&sums, stream);
    for (size_t i = 0; i < report->step_count; i++)
        if (report->steps[i].stage == stage && report_shows(report, &report->steps[i]))
            write_case(&report->steps[i], stream);
    if (report_scatter(report, stage))
        write_scatter(report_scatter(report, stage), stream);
    fputs("  </testsuite>\n", stream);
}

bool report_junit(const Report *report, FILE *stream, Error *error)
{
    (void)error;
    ReportSums sums = sums_of_stage(report, 0);
    fputs("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"", stream);
    text_markup(stream, report->submission);
    fputc('"', stream);
    write_counts(&sums, stream);
    for (int stage = 1; stage <= 99; stage++)
        write_stage(report, stage, stream);
    fputs("</testsuites>\n", stream);
    return true;
}
