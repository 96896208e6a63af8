// The probe's run on a step's cases: what it may see, and what it must give back.
#define _GNU_SOURCE // mkostemp
#include "cli/probe_sizes.h"
#include "crash.h"
#include "file.h"
#include "grade.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define MAGIC     "photonlab probe 1\n"
#define MEMORY_MB 512
#define RESULT_MB 64

static bool is_listed(const char *list, const char *id)
{
    const char *found = list ? strstr(list, id) : NULL;
    return found != NULL;
}

// Which solutions may be in the probe's sight: never the step's own, nor one that does the same work.
static bool is_visible(const StepChecks *checks, const StepInfo *step, const StepInfo *other, bool scene)
{
    if (other == step || is_listed(checks->twins, other->id))
        return false;
    return scene || is_listed(checks->needs, other->id);
}

typedef struct {
    char program[4096], library[4096], scenes[4096], references[4096], object[4096], cases[4096];
    char solutions[STEP_COUNT][4096];
} Paths;

static void find_paths(const GradeOptions *o, const StepInfo *step, bool scene, Paths *p)
{
    char directory[4000];
    step_directory(o, step, directory, sizeof directory);
    snprintf(p->program, sizeof p->program, "%s/photonlab", o->build);
    snprintf(p->library, sizeof p->library, "%s/libphotonlab.so", o->build);
    snprintf(p->scenes, sizeof p->scenes, "%s/tests/steps/scenes", o->root);
    snprintf(p->references, sizeof p->references, "%s/solutions", o->build);
    snprintf(p->object, sizeof p->object, "%s/step.so", directory);
    snprintf(p->cases, sizeof p->cases, "%s/%s.txt", directory, scene ? "scenes" : "calls");
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
    size_t at = strlen(MAGIC), used = 0;
    *forged = size >= at && memcmp(bytes, MAGIC, at) != 0;
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

// What the student's code printed: all but the line that the probe leaves when it crashes.
static void copy_printed(const char *text, char *output, size_t size)
{
    size_t used = 0;
    for (const char *line = text; *line && used + 1 < size;) {
        size_t length = strcspn(line, "\n");
        bool ours = strncmp(line, "photonlab-crash ", 16) == 0;
        size_t whole = length + (line[length] == '\n');
        size_t copied = whole < size - 1 - used ? whole : size - 1 - used;
        if (!ours && (used > 0 || length > 0)) { // no empty lines at the beginning
            memcpy(output + used, line, copied);
            used += copied;
        }
        line += whole;
    }
    output[used] = '\0';
}

static Status run_failed(const Error *error, StepResult *result)
{
    snprintf(result->message, sizeof result->message, "the judge could not run it: %.900s", error->message);
    return STATUS_SKIP;
}

Status run_probe(const GradeOptions *options, const StepInfo *step, bool scene, char *const *lines, size_t count,
                 Numbers *numbers, float **storage, long *crashed_case, StepResult *result)
{
    Paths p;
    SandboxResult ran;
    const StepChecks *checks = checks_of(step->id);
    Error error = {""};
    char directory[4000];
    step_directory(options, step, directory, sizeof directory);
    find_paths(options, step, scene, &p);
    int fd = open_result(directory, &error);
    if (fd < 0 || !write_cases(p.cases, lines, count, &error))
        return run_failed(&error, result);

    const char *const arguments[] = {p.program,    "probe", "--step", step->id, "--object",    p.object, "--references",
                                     p.references, "--fd",  "3",      "--root", options->root, p.cases,  NULL};
    SandboxRun run = {.arguments = arguments,
                      .visible = {p.program, p.library, p.object, p.cases},
                      .result_fd = fd,
                      .cpu_seconds = options->cpu_seconds * options->speed,
                      .wall_seconds = 6.0 * options->cpu_seconds * options->speed,
                      .memory_mb = options->memory_limit ? MEMORY_MB : 0,
                      .file_mb = RESULT_MB};
    memcpy(run.hidden, options->hidden, sizeof run.hidden);
    int visible = 4;
    if (scene) {
        run.visible[visible++] = p.scenes;
    }
    for (size_t i = 0; i < STEP_COUNT; i++) {
        snprintf(p.solutions[i], sizeof p.solutions[i], "%s/solutions/%s.so", options->build, step_table[i].file);
        if (is_visible(checks, step, &step_table[i], scene))
            run.visible[visible++] = p.solutions[i];
    }
    bool started = sandbox_run(options->sandbox, &run, &ran, &error);
    size_t size = 0, total = 0;
    for (size_t i = 0; i < count; i++)
        total += probe_case_size(step->id, lines[i]);
    unsigned char *bytes = started ? read_result(fd, &size) : NULL;
    close(fd);
    *storage = malloc((total + 1) * sizeof **storage);
    if (!started || !bytes || !*storage) {
        free(bytes);
        return run_failed(&error, result);
    }
    bool forged = false;
    size_t whole = parse_result(bytes, size, step->id, lines, count, numbers, *storage, &forged);
    free(bytes);
    *crashed_case = (long)whole;
    copy_printed(ran.text, result->output + result->compiled, sizeof result->output - result->compiled);
    if (forged) {
        snprintf(result->message, sizeof result->message, "something other than the probe wrote to the results");
        return STATUS_ERROR;
    }
    if (ran.exit_code == 0 && whole == count)
        return STATUS_PASS;
    crash_describe(options, &ran, p.object, step->symbol, result);
    return STATUS_ERROR;
}
