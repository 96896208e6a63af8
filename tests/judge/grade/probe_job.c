#define _GNU_SOURCE // mkostemp
#include "judge/grade/grade.h"
#include "judge/probe/probe_sizes.h"
#include "base/file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define MEMORY_MB 512
#define RESULT_MB 64

typedef struct {
    char paths[MOST_VISIBLE][4096];
    int count;
} Visible;

static PRINTF_LIKE(2, 3) void show(Visible *visible, const char *format, ...)
{
    if (visible->count == MOST_VISIBLE - 1)
        return;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(visible->paths[visible->count++], sizeof *visible->paths, format, arguments);
    va_end(arguments);
}

static void show_all(const GradeOptions *options, const ProbeJob *job, const char *cases, Visible *visible)
{
    visible->count = 0;
    show(visible, "%s/probe", options->build);
    show(visible, "%s/libphotonlab.so", options->build);
    show(visible, "%s/tests/steps/scenes", options->root);
    show(visible, "%s", cases);
    for (size_t i = 0; i < STEP_COUNT; i++) {
        if (job->student[i])
            show(visible, "%s/%s/step.so", options->work, step_table[i].id);
        if (!job->hidden[i])
            show(visible, "%s/solutions/%s.so", options->build, step_table[i].file);
    }
}

static bool write_cases(const char *path, char *const *lines, size_t count, Error *error)
{
    FileWriter writer;
    if (!file_write_begin(&writer, path, error))
        return false;
    for (size_t i = 0; i < count; i++)
        fprintf(writer.stream, "%s\n", lines[i]);
    return file_write_end(&writer, true, error);
}

// A file without a name: nothing that the student's code does can put another in its place.
static int open_result(const char *directory, Error *error)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/result-XXXXXX", directory);
    int fd = mkostemp(path, O_CLOEXEC);
    if (fd < 0) {
        error_set(error, "%s: %s", path, strerror(errno));
        return -1;
    }
    unlink(path);
    return fd;
}

static unsigned char *read_result(int fd, size_t *size)
{
    struct stat state;
    if (fstat(fd, &state) != 0 || state.st_size < 0 || state.st_size > ((off_t)RESULT_MB << 20))
        return NULL;
    *size = (size_t)state.st_size;
    unsigned char *bytes = malloc(*size + 8);
    size_t done = 0;
    while (bytes && done < *size) {
        ssize_t got = pread(fd, bytes + done, *size - done, (off_t)done);
        if (got <= 0)
            break;
        done += (size_t)got;
    }
    *size = done;
    return bytes;
}

// Takes the cases apart, strictly. Returns how many are whole; *forged when something stands there that no probe writes.
static size_t parse_result(const unsigned char *bytes, size_t size, const char *id, char *const *lines, size_t count,
                           Numbers *numbers, float *storage, bool *forged)
{
    size_t at = strlen(PROBE_MAGIC), used = 0;
    *forged = size >= at && memcmp(bytes, PROBE_MAGIC, at) != 0;
    for (size_t i = 0; i < count; i++) {
        uint32_t head[2];
        size_t expected = probe_case_size(id, lines[i]);
        if (*forged || at + sizeof head > size)
            return i;
        memcpy(head, bytes + at, sizeof head);
        *forged = head[0] != i || head[1] != expected;
        if (*forged || at + sizeof head + expected * sizeof(float) > size)
            return i;
        memcpy(storage + used, bytes + at + sizeof head, expected * sizeof(float));
        numbers[i] = (Numbers){storage + used, expected};
        used += expected;
        at += sizeof head + expected * sizeof(float);
    }
    *forged = at != size;
    return count;
}

static bool run_it(const GradeOptions *options, const ProbeJob *job, const char *cases, int fd, SandboxResult *ran,
                   Error *error)
{
    char references[4200], object[4200];
    Visible visible;
    show_all(options, job, cases, &visible);
    snprintf(references, sizeof references, "%s/solutions", options->build);
    snprintf(object, sizeof object, "%s/step.so", job->directory);
    const char *const one[] = {"--step", job->id, "--object", object};
    const char *const several[] = {"--several", job->list, "--objects", options->work};
    const char *const *who = job->id ? one : several, *program = visible.paths[0];
    const char *const arguments[] = {program, "--references", references, "--fd", "3",   "--root", options->root,
                                     who[0],  who[1],         who[2],     who[3], cases, NULL};
    SandboxRun run = {.arguments = arguments,
                      .result_fd = fd,
                      .cpu_seconds = job->cpu_seconds * options->speed,
                      .wall_seconds = 3.0 * job->cpu_seconds * options->speed,
                      .memory_mb = options->memory_limit ? MEMORY_MB : 0,
                      .file_mb = RESULT_MB};
    memcpy(run.hidden, options->hidden, sizeof run.hidden);
    for (int i = 0; i < visible.count; i++)
        run.visible[i] = visible.paths[i];
    return sandbox_run(options->sandbox, &run, ran, error);
}

Status probe_job_run(const GradeOptions *options, const ProbeJob *job, char *const *lines, size_t count,
                     Numbers *numbers, ProbeRun *run)
{
    const char *id = job->id ? job->id : "";
    char cases[4096];
    Error error = {""};
    memset(run, 0, sizeof *run);
    int fd = open_result(job->directory, &error);
    snprintf(cases, sizeof cases, "%s/%s", job->directory, job->cases);
    bool ready = fd >= 0 && write_cases(cases, lines, count, &error);
    bool started = ready && run_it(options, job, cases, fd, &run->sandbox, &error);
    size_t size = 0, total = 0;
    for (size_t i = 0; i < count; i++)
        total += probe_case_size(id, lines[i]);
    unsigned char *bytes = started ? read_result(fd, &size) : NULL;
    if (fd >= 0)
        close(fd);
    run->storage = malloc((total + 1) * sizeof *run->storage);
    if (!started || !bytes || !run->storage) {
        free(bytes);
        snprintf(run->message, sizeof run->message, "the judge could not run it: %.900s", error.message);
        return STATUS_SKIP;
    }
    run->whole = parse_result(bytes, size, id, lines, count, numbers, run->storage, &run->forged);
    free(bytes);
    if (run->forged) {
        snprintf(run->message, sizeof run->message, "something other than the probe wrote to the results");
        return STATUS_ERROR;
    }
    return run->sandbox.exit_code == 0 && run->whole == count ? STATUS_PASS : STATUS_ERROR;
}
