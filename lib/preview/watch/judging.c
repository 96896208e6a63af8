#include "preview/watch/judging.h"
#include "base/parallel.h"
#include "base/process.h"
#include "base/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LONGEST 300.0 // s; the judge has limits of its own

struct Judging {
    char *command;
    int wanted[STEP_COUNT]; // the lowest number above 0 comes next; 0: is not wanted
    int last, first;        // numbers given
    size_t step;            // under way
    Process judge;
    double started;
    char text[8192];
    size_t size;
};

Judging *judging_start(const char *command)
{
    Judging *judging = calloc(1, sizeof *judging);
    char *copy = malloc(strlen(command) + 1);
    if (!judging || !copy) {
        free(judging);
        free(copy);
        return NULL;
    }
    judging->command = strcpy(copy, command);
    judging->judge.output = -1;
    judging->last = judging->first = STEP_COUNT * 1000000;
    return judging;
}

void judging_stop(Judging *judging)
{
    if (!judging)
        return;
    process_end(&judging->judge);
    free(judging->command);
    free(judging);
}

void judging_want(Judging *judging, Verdicts *verdicts, size_t step, bool soon)
{
    judging->wanted[step] = soon ? --judging->first : ++judging->last;
    verdicts->steps[step].old = verdicts->steps[step].state != VERDICT_NONE;
    verdicts->steps[step].judged_now = true;
    if (!soon || judging->judge.pid <= 0)
        return;
    if (judging->step != step) // that one waits
        judging_want(judging, verdicts, judging->step, false);
    process_end(&judging->judge);
}

// The judge's line, or, where there is none, its last words.
static void take_verdict(Judging *judging, Verdicts *verdicts)
{
    const char *line = judging->text, *last = "the judge said nothing";
    Verdict *verdict = &verdicts->steps[judging->step];
    for (; *line; line += strcspn(line, "\n") + 1) {
        const StepInfo *step = verdicts_take_line(verdicts, line);
        if (step == &step_table[judging->step])
            return;
        last = line;
        if (!strchr(line, '\n'))
            break;
    }
    *verdict = (Verdict){.state = VERDICT_SKIP};
    snprintf(verdict->message, sizeof verdict->message, "not judged: %.*s", (int)strcspn(last, "\n"), last);
}

static void begin_next(Judging *judging, Verdicts *verdicts)
{
    size_t next = STEP_COUNT;
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (judging->wanted[i] > 0 && (next == STEP_COUNT || judging->wanted[i] < judging->wanted[next]))
            next = i;
    if (next == STEP_COUNT)
        return;
    const char *const arguments[] = {"/bin/sh", "-c", judging->command, "sh", step_table[next].id, NULL};
    judging->wanted[next] = 0;
    judging->step = next;
    judging->size = 0;
    judging->text[0] = '\0';
    judging->started = clock_seconds();
    if (!process_start(&judging->judge, arguments, PRINTS_ALL))
        take_verdict(judging, verdicts);
}

const StepInfo *judging_poll(Judging *judging, Verdicts *verdicts)
{
    int status;
    if (judging->judge.pid <= 0) {
        begin_next(judging, verdicts);
        return NULL;
    }
    process_read(&judging->judge, judging->text, sizeof judging->text, &judging->size);
    if (clock_seconds() - judging->started > LONGEST)
        process_end(&judging->judge);
    else if (!process_has_ended(&judging->judge, &status))
        return NULL;
    process_read(&judging->judge, judging->text, sizeof judging->text, &judging->size);
    process_end(&judging->judge);
    take_verdict(judging, verdicts);
    return &step_table[judging->step];
}
