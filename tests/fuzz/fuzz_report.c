// report.json: all six writers write of what was read, for both kinds of readers; or a message.
#include "fuzz/fuzz.h"
#include "judge/report/report.h"

static void write_all(Report *report)
{
    ReportWriter *const writers[] = {report_html, report_junit, report_tap, report_gradescope, report_prairielearn};
    Error error = {""};
    for (size_t i = 0; i < sizeof writers / sizeof *writers; i++) {
        char *bytes = NULL;
        size_t size = 0;
        FILE *stream = open_memstream(&bytes, &size);
        require(stream != NULL);
        bool fine = writers[i](report, stream, &error);
        require(fclose(stream) == 0 && fine == !error.message[0]);
        free(bytes);
    }
    require(report_write(report, &error)); // the judge's own, over what was read
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_file("report.json", data, size);
    for (int teacher = 0; teacher < 2; teacher++) {
        Report report;
        Error error = {""};
        bool fine = report_read(&report, fuzz_folder(), &error);
        require(fine == !error.message[0]);
        report.teacher = teacher;
        report.notes = teacher ? "../notes" : NULL;
        if (fine)
            write_all(&report);
        report_free(&report);
    }
    return 0;
}
