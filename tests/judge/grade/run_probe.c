// The probe's run on a step's cases: what of the others' work it may see, and what the student is told.
#include "judge/grade/probe_job.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Which solutions may be in the probe's sight: never the step's own, nor one that does the same work.
static bool is_visible(const StepInfo *step, const StepInfo *other, bool scene)
{
    return other != step && !steps_are_paired(step, other) && (scene || step_is_listed(step->needs, other->id));
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

static void make_job(const GradeOptions *options, const StepInfo *step, bool scene, const char *directory,
                     const char *cases, const char *object, ProbeJob *job)
{
    probe_job_start(options, directory, cases, job);
    const char *const words[] = {"--step", step->id, "--object", object};
    probe_job_words(job, words, 4);
    probe_job_show(job, "%s", object);
    probe_job_show(job, "%s/tests/steps/scenes", options->root);
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (is_visible(step, &step_table[i], scene))
            probe_job_show(job, "%s/solutions/%s.so", options->build, step_table[i].file);
}

Status run_probe(const GradeOptions *options, const StepInfo *step, bool scene, char *const *lines, size_t count,
                 Numbers *numbers, float **storage, long *crashed_case, StepResult *result)
{
    char directory[4000], object[4096];
    step_directory(options, step, directory, sizeof directory);
    snprintf(object, sizeof object, "%s/step.so", directory);
    ProbeJob job;
    ProbeRun ran;
    make_job(options, step, scene, directory, scene ? "scenes.txt" : "calls.txt", object, &job);
    Status status = probe_job_run(options, &job, step->id, lines, count, numbers, &ran);
    *storage = ran.storage;
    if (*ran.message)
        snprintf(result->words.message, sizeof result->words.message, "%s", ran.message);
    if (status != STATUS_SKIP) {
        *crashed_case = (long)ran.whole;
        copy_printed(ran.sandbox.text, result->words.output + result->words.compiled,
                     sizeof result->words.output - result->words.compiled);
    }
    if (status == STATUS_ERROR && !ran.forged)
        crash_describe(options, &ran.sandbox, object, step->symbol, &result->words);
    return status;
}

// The line of this number, from 0; the caller frees it. NULL: it cannot be read.
static char *line_of(const char *path, long number)
{
    FILE *stream = fopen(path, "r");
    char *line = NULL;
    size_t size = 0;
    long at = -1;
    while (stream && at < number && getline(&line, &size, stream) >= 0)
        at++;
    if (stream)
        fclose(stream);
    if (at == number)
        line[strcspn(line, "\n")] = '\0';
    else
        free(line);
    return at == number ? line : NULL;
}

void show_printed(const GradeOptions *options, StepResult *result)
{
    char *printed = result->words.output + result->words.compiled, directory[4000], path[4096], object[4096];
    if (!*printed || !result->failing_cases)
        return;
    step_directory(options, result->step, directory, sizeof directory);
    snprintf(path, sizeof path, "%s/%s", directory, result->failing_cases);
    snprintf(object, sizeof object, "%s/step.so", directory);
    char *line = line_of(path, result->failing_case);
    ProbeJob job;
    ProbeRun ran;
    Numbers numbers;
    make_job(options, result->step, strcmp(result->failing_cases, "scenes.txt") == 0, directory, "failing.txt", object,
             &job);
    if (line && probe_job_run(options, &job, result->step->id, &line, 1, &numbers, &ran) != STATUS_SKIP) {
        size_t room = sizeof result->words.output - result->words.compiled;
        size_t said = (size_t)snprintf(printed, room, "(in the case that failed)\n");
        copy_printed(ran.sandbox.text, printed + said, room - said);
    }
    free(line ? ran.storage : NULL);
    free(line);
}
