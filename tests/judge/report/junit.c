// JUnit XML as Jenkins, GitLab and GitHub's actions read it: a suite per stage, a test case per step and one for its scatter. Checked against
// junit.xsd beside.
#include "report.h"

#include <stdlib.h>

// The sums of one stage; stage 0: of all.
static ReportSums sums_of_stage(const Report *report, int stage)
{
    ReportSums sums = report_sums(report, report->teacher, stage);
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

static void write_result(const ReportStep *step, const char *words, FILE *stream)
{
    const StatusInfo *status = &status_table[step->status];
    const char *message = *step->message ? step->message : status->words;
    const char *element = step->status == STATUS_FAIL ? "failure" : "error";
    if (status_is_wrong(step->status))
        text_put(stream, "      <%s message=\"%s\" type=\"%s\">%s</%s>\n", element, message,
                 *step->mistake ? step->mistake : status->name, words, element);
    else if (step->status != STATUS_PASS)
        text_put(stream, "      <skipped message=\"%s\"/>\n", message);
}

static void write_case(const ReportStep *step, const char *words, FILE *stream)
{
    text_put(stream, "    <testcase classname=\"photonlab.stage_%d\" name=\"%s %s\"", step->stage, step->id,
             step->title);
    fprintf(stream, " time=\"%.3f\">\n", step->seconds);
    write_result(step, words, stream);
    if (*step->output)
        text_put(stream, "      <system-out>%s</system-out>\n", step->output);
    fputs("    </testcase>\n", stream);
}

static void write_step(const ReportStep *step, FILE *stream)
{
    char *words = words_of_step(step, 0);
    write_case(step, words ? words : "", stream);
    free(words);
}

static void write_scatter(const ReportScatter *scatter, FILE *stream)
{
    char words[5000], title[32];
    ReportStep step = report_scatter_step(scatter, title);
    words_of_scatter(scatter, words, sizeof words);
    write_case(&step, words, stream);
}

static void write_stage(const Report *report, int stage, FILE *stream)
{
    ReportSums sums = sums_of_stage(report, stage);
    if (sums.steps == 0)
        return;
    fprintf(stream, "  <testsuite name=\"stage %d\"", stage);
    write_counts(&sums, stream);
    for (const ReportStep *step = NULL; (step = report_next(report, step));)
        if (step->stage == stage)
            write_step(step, stream);
    if (report_scatter(report, stage))
        write_scatter(report_scatter(report, stage), stream);
    fputs("  </testsuite>\n", stream);
}

bool report_junit(const Report *report, FILE *stream, Error *error)
{
    (void)error;
    ReportSums sums = sums_of_stage(report, 0);
    text_put(stream, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"%s\"", report->submission);
    write_counts(&sums, stream);
    for (int stage = 1; stage <= 99; stage++)
        write_stage(report, stage, stream);
    fputs("</testsuites>\n", stream);
    return true;
}
