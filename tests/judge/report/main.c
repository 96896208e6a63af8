#include "base/command_line.h"
#include "base/file.h"
#include "report.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

static const char help[] =
    "usage: report [--teacher] [--notes PATH] [--finale PATH] DIR\n"
    "\n"
    "Reads DIR/report.json, which the judge writes, and writes beside it index.html, junit.xml, report.tap,\n"
    "gradescope/results.json and prairielearn/results.json.\n"
    "\n"
    "  --teacher      show hidden steps, too (in index.html, junit.xml and report.tap)\n"
    "  --notes PATH   where the course notes lie, seen from DIR: chapters become links, PATH/2_glossy_lobe.html#lobe\n"
    "  --finale PATH  the picture of `make finale`, seen from DIR: the page ends with it\n";

static const struct {
    const char *folder, *name;
    ReportWriter *write;
} files[] = {{NULL, "index.html", report_html},
             {NULL, "junit.xml", report_junit},
             {NULL, "report.tap", report_tap},
             {"gradescope", "gradescope/results.json", report_gradescope},
             {"prairielearn", "prairielearn/results.json", report_prairielearn}};

static bool write_one(const Report *report, size_t i, Error *error)
{
    char path[MOST_PATH];
    if (files[i].folder && mkdir(report_path(report, files[i].folder, path), 0777) != 0 && errno != EEXIST)
        return error_set(error, "%s: cannot be made: %s", path, strerror(errno));
    FileWriter writer;
    if (!file_write_begin(&writer, report_path(report, files[i].name, path), error))
        return false;
    bool good = files[i].write(report, writer.stream, error);
    return file_write_end(&writer, good, error) && good;
}

// A link to the notes must stay beside the report: no scheme ("javascript:"), no other host.
static bool is_beside(const char *path)
{
    return path[0] != '\0' && path[0] != '/' && !strpbrk(path, ":\\");
}

// 0 when the arguments are right, otherwise the exit code or HELP_SHOWN.
static int parse(int count, char **arguments, Report *report)
{
    const Flag flags[] = {
        {"teacher", FLAG_PRESENT, &report->teacher, 0, 0},
        {"notes", FLAG_TEXT, &report->notes, 0, 0},
        {"finale", FLAG_TEXT, &report->finale, 0, 0},
    };
    int wrong = command_line_parse(&(CommandLine){"report", help, "one directory", flags, FLAG_COUNT(flags), 1, 1},
                                   count, arguments, &report->directory);
    const char *const paths[] = {report->notes, report->finale};
    for (int i = 0; !wrong && i < 2; i++)
        if (paths[i] && !is_beside(paths[i]))
            return report_usage("report", "%s: expected a relative path", paths[i]);
    return wrong;
}

int main(int count, char **arguments)
{
    Report flags = {.notes = NULL}, report;
    Error error = {""};
    int wrong = parse(count, arguments, &flags);
    if (wrong)
        return wrong == HELP_SHOWN ? 0 : wrong;
    bool good = report_read(&report, flags.directory, &error);
    report.teacher = flags.teacher;
    report.notes = flags.notes;
    report.finale = flags.finale;
    for (size_t i = 0; good && i < sizeof files / sizeof *files; i++)
        good = write_one(&report, i, &error);
    report_free(&report);
    if (!good)
        fprintf(stderr, "report: %s\n", error.message);
    return good ? 0 : 1;
}
