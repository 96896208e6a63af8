#include "base/file.h"
#include "report.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static const char usage[] =
    "report [--teacher] [--notes PATH] DIR\n"
    "\n"
    "Reads DIR/report.json, which the judge writes, and writes beside it index.html, junit.xml, report.tap,\n"
    "gradescope/results.json, prairielearn/results.json and classroom.txt.\n"
    "\n"
    "  --teacher      show hidden steps, too (in index.html, junit.xml and report.tap)\n"
    "  --notes PATH   where the course notes lie, seen from DIR: chapters become links, PATH/2_glossy_lobe.html#lobe\n";

static const struct {
    const char *folder, *name;
    ReportWriter *write;
} files[] = {{NULL, "index.html", report_html},
             {NULL, "junit.xml", report_junit},
             {NULL, "report.tap", report_tap},
             {"gradescope", "gradescope/results.json", report_gradescope},
             {"prairielearn", "prairielearn/results.json", report_prairielearn},
             {NULL, "classroom.txt", report_classroom}};

// directory/name in memory of the report's.
static const char *path_in(Report *report, const char *name)
{
    size_t size = strlen(report->directory) + strlen(name) + 2;
    char *path = report_keep(report, size);
    snprintf(path, size, "%s/%s", report->directory, name);
    return path;
}

static bool write_one(Report *report, size_t i, Error *error)
{
    if (files[i].folder) {
        const char *folder = path_in(report, files[i].folder);
        if (mkdir(folder, 0777) != 0 && errno != EEXIST)
            return error_set(error, "%s: cannot be made: %s", folder, strerror(errno));
    }
    FileWriter writer;
    if (!file_write_begin(&writer, path_in(report, files[i].name), error))
        return false;
    bool good = files[i].write(report, writer.stream, error);
    return file_write_end(&writer, good, error) && good;
}

// A link to the notes must stay beside the report: no scheme ("javascript:"), no other host.
static bool is_beside(const char *path)
{
    return path[0] != '\0' && path[0] != '/' && !strpbrk(path, ":\\");
}

static int complain(const char *what, const char *about)
{
    fprintf(stderr, "report: %s%s\n\n%s", what, about, usage);
    return 2;
}

// 0: go on; 2: the flags are wrong; −1: help was asked for.
static int read_flags(int count, char **words, Report *flags)
{
    for (int i = 1; i < count; i++) {
        if (strcmp(words[i], "--help") == 0)
            return -1;
        if (strcmp(words[i], "--teacher") == 0)
            flags->teacher = true;
        else if (strcmp(words[i], "--notes") == 0 && i + 1 < count)
            flags->notes = words[++i];
        else if (words[i][0] == '-')
            return complain("unknown flag, or one without its value: ", words[i]);
        else if (flags->directory)
            return complain("one directory at a time, not also ", words[i]);
        else
            flags->directory = words[i];
    }
    if (!flags->directory)
        return complain("which directory?", "");
    if (flags->notes && !is_beside(flags->notes))
        return complain("--notes: expected a relative path; found ", flags->notes);
    return 0;
}

int main(int count, char **words)
{
    Report flags = {.notes = NULL}, report;
    Error error = {""};
    int wrong = read_flags(count, words, &flags);
    if (wrong == -1)
        return fputs(usage, stdout) == EOF;
    if (wrong)
        return wrong;
    bool good = report_read(&report, flags.directory, &error);
    report.teacher = flags.teacher;
    report.notes = flags.notes;
    for (size_t i = 0; good && i < sizeof files / sizeof *files; i++)
        good = write_one(&report, i, &error);
    report_free(&report);
    if (!good)
        fprintf(stderr, "report: %s\n", error.message);
    return good ? 0 : 1;
}
