#define _GNU_SOURCE // mkostemp
#include "judge/grade/probe_job.h"
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

void probe_job_start(const GradeOptions *options, const char *directory, const char *cases, ProbeJob *job)
{
    memset(job, 0, sizeof *job);
    job->directory = directory;
    job->cpu_seconds = options->cpu_seconds;
    snprintf(job->cases, sizeof job->cases, "%s/%s", directory, cases);
    probe_job_show(job, "%s/probe", options->build);
    probe_job_show(job, "%s/libphotonlab.so", options->build);
    probe_job_show(job, "%s", job->cases);
}

void probe_job_words(ProbeJob *job, const char *const *words, int count)
{
    for (int i = 0; i < count && job->word_count < (int)(sizeof job->words / sizeof *job->words); i++)
        job->words[job->word_count++] = words[i];
}

void probe_job_show(ProbeJob *job, const char *format, ...)
{
    if (job->visible_count == MOST_VISIBLE - 1)
        return;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(job->visible[job->visible_count], sizeof *job->visible, format, arguments);
    va_end(arguments);
    job->visible_count++;
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

static Status could_not_run(const Error *error, ProbeRun *run)
{
    snprintf(run->message, sizeof run->message, "the judge could not run it: %.900s", error->message);
    return STATUS_SKIP;
}

static bool run_it(const GradeOptions *options, const ProbeJob *job, int fd, SandboxResult *ran, Error *error)
{
    char references[4200];
    snprintf(references, sizeof references, "%s/solutions", options->build);
    const char *arguments[32] = {job->visible[0], "--references", references, "--fd", "3", "--root", options->root};
    int count = 7;
    for (int i = 0; i < job->word_count; i++)
        arguments[count++] = job->words[i];
    arguments[count] = job->cases;
    SandboxRun run = {.arguments = arguments,
                      .result_fd = fd,
                      .cpu_seconds = job->cpu_seconds * options->speed,
                      .wall_seconds = 3.0 * job->cpu_seconds * options->speed,
                      .memory_mb = options->memory_limit ? MEMORY_MB : 0,
                      .file_mb = RESULT_MB};
    memcpy(run.hidden, options->hidden, sizeof run.hidden);
    for (int i = 0; i < job->visible_count; i++)
        run.visible[i] = job->visible[i];
    return sandbox_run(options->sandbox, &run, ran, error);
}

Status probe_job_run(const GradeOptions *options, const ProbeJob *job, const char *id, char *const *lines, size_t count,
                     Numbers *numbers, ProbeRun *run)
{
    Error error = {""};
    memset(run, 0, sizeof *run);
    int fd = open_result(job->directory, &error);
    bool ready = fd >= 0 && write_cases(job->cases, lines, count, &error);
    bool started = ready && run_it(options, job, fd, &run->sandbox, &error);
    size_t size = 0, total = 0;
    for (size_t i = 0; i < count; i++)
        total += probe_case_size(id, lines[i]);
    unsigned char *bytes = started ? read_result(fd, &size) : NULL;
    if (fd >= 0)
        close(fd);
    run->storage = malloc((total + 1) * sizeof *run->storage);
    if (!started || !bytes || !run->storage) {
        free(bytes);
        return could_not_run(&error, run);
    }
    run->whole = parse_result(bytes, size, id, lines, count, numbers, run->storage, &run->forged);
    free(bytes);
    if (run->forged) {
        snprintf(run->message, sizeof run->message, "something other than the probe wrote to the results");
        return STATUS_ERROR;
    }
    return run->sandbox.exit_code == 0 && run->whole == count ? STATUS_PASS : STATUS_ERROR;
}
