// The probe's run on a step's cases: what of the others' work it may see, and what the student is told.
#include "judge/grade/grade.h"

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

static ProbeJob make_job(const GradeOptions *options, const StepInfo *step, bool scene, const char *cases)
{
    ProbeJob job = {.cases = cases, .id = step->id, .cpu_seconds = options->cpu_seconds};
    step_directory(options, step, job.directory, sizeof job.directory);
    for (size_t i = 0; i < STEP_COUNT; i++)
        job.hidden[i] = !is_visible(step, &step_table[i], scene);
    job.student[step - step_table] = true;
    return job;
}

Status run_probe(const GradeOptions *options, bool scene, const Plan *plan, Numbers *numbers, float **storage,
                 long *crashed_case, StepResult *result)
{
    ProbeJob job = make_job(options, result->step, scene, scene ? "scenes.txt" : "calls.txt");
    ProbeRun ran;
    Status status = probe_job_run(options, &job, plan->lines, plan->count, numbers, &ran);
    *storage = ran.storage;
    if (*ran.message)
        words_say(&result->words, status, "%s", ran.message);
    if (status != STATUS_SKIP) {
        *crashed_case = (long)ran.whole;
        copy_printed(ran.sandbox.text, result->words.output + result->words.compiled,
                     sizeof result->words.output - result->words.compiled);
    }
    if (status == STATUS_ERROR && !ran.forged)
        crash_describe(options, &ran.sandbox, result->step, &result->words);
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
    char *printed = result->words.output + result->words.compiled, path[4096];
    if (!*printed || !result->failing_cases)
        return;
    bool scene = strcmp(result->failing_cases, "scenes.txt") == 0;
    ProbeJob job = make_job(options, result->step, scene, "failing.txt");
    snprintf(path, sizeof path, "%s/%s", job.directory, result->failing_cases);
    char *line = line_of(path, result->failing_case);
    ProbeRun ran = {.storage = NULL};
    Numbers numbers;
    if (line && probe_job_run(options, &job, &line, 1, &numbers, &ran) != STATUS_SKIP) {
        size_t room = sizeof result->words.output - result->words.compiled;
        size_t said = (size_t)snprintf(printed, room, "(in the case that failed)\n");
        copy_printed(ran.sandbox.text, printed + said, room - said);
    }
    free(ran.storage);
    free(line);
}
