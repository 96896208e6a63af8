#include "preview/watch/coach.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LONGEST 300.0 // s; the judge has limits of its own

void coach_start(Coach *coach, const char *judging, int stage, int stages)
{
    *coach = (Coach){.judging = judging, .stage = stage, .verdicts = {.count = step_count_of(stages)}};
    coach->last = coach->first = STEP_COUNT * 1000000;
    coach->judge.process.output = -1;
}

void coach_stop(Coach *coach)
{
    if (coach->judging)
        process_end(&coach->judge.process);
}

// Its verdict is wanted: soon, or after those that are wanted already. What it says of it at present is old.
static void want(Coach *coach, size_t step, bool soon)
{
    Verdict *verdict = &coach->verdicts.steps[step];
    coach->wanted[step] = soon ? --coach->first : ++coach->last;
    verdict->old = verdict->state != VERDICT_NONE;
    verdict->judged_now = true;
    if (!soon || coach->judge.process.pid <= 0)
        return;
    if (coach->judged != step) // that one waits
        want(coach, coach->judged, false);
    process_end(&coach->judge.process);
}

// The judge's line, or, where there is none, its last words.
static void take_verdict(Coach *coach)
{
    const char *line = coach->judge.text, *last = "the judge said nothing";
    Verdict *verdict = &coach->verdicts.steps[coach->judged];
    for (; *line; line += strcspn(line, "\n") + 1) {
        if (verdicts_take_line(&coach->verdicts, line) == &step_table[coach->judged])
            return;
        last = line;
        if (!strchr(line, '\n'))
            break;
    }
    *verdict = (Verdict){.state = VERDICT_SKIP};
    snprintf(verdict->message, sizeof verdict->message, "not judged: %.*s", (int)strcspn(last, "\n"), last);
}

static void judge_next(Coach *coach)
{
    size_t next = STEP_COUNT;
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (coach->wanted[i] > 0 && (next == STEP_COUNT || coach->wanted[i] < coach->wanted[next]))
            next = i;
    if (next == STEP_COUNT)
        return;
    coach->wanted[next] = 0;
    coach->judged = next;
    if (!job_start(&coach->judge, coach->judging, step_table[next].id, NULL))
        take_verdict(coach);
}

// Of the stage that was asked for, the first step that is not started; otherwise of all, or the first.
static size_t first_open(const Coach *coach, const StepState states[STEP_COUNT])
{
    size_t count = coach->verdicts.count, first = count;
    for (size_t i = 0; i < count; i++) {
        bool open = states[i] != STEP_STUDENT;
        bool of_stage = coach->stage == 0 || step_table[i].stage == coach->stage;
        if (open && of_stage)
            return i;
        first = first == count && of_stage ? i : first;
    }
    return first < count ? first : 0;
}

void coach_note_states(Coach *coach, const StepState states[STEP_COUNT])
{
    Verdicts *verdicts = &coach->verdicts;
    if (!coach->judging)
        return;
    for (size_t i = 0; i < verdicts->count; i++) {
        Verdict *verdict = &verdicts->steps[i];
        if (states[i] != STEP_STUDENT && verdict->state != VERDICT_ERROR)
            *verdict = (Verdict){.state = VERDICT_TODO};
        else if (verdict->state == VERDICT_NONE && !verdict->judged_now)
            want(coach, i, false);
    }
    if (!coach->stated)
        verdicts->present = first_open(coach, states);
    coach->stated = true;
}

static void choose_step(Coach *coach, size_t step)
{
    coach->verdicts.present = step;
    coach->verdicts.hint[0] = '\0';
}

// A file of a step that the course does not have may still lie there.
static bool is_of_course(const Coach *coach, const StepInfo *step)
{
    return (size_t)(step - step_table) < coach->verdicts.count;
}

void coach_judge(Coach *coach, const StepInfo *step)
{
    if (!coach->judging || !coach->stated || !is_of_course(coach, step)) // all that are started will be
        return;
    choose_step(coach, (size_t)(step - step_table));
    want(coach, (size_t)(step - step_table), true);
}

void coach_note_broken(Coach *coach, const StepInfo *step, const char *message)
{
    Verdict *verdict = &coach->verdicts.steps[step - step_table];
    if (!coach->judging || !is_of_course(coach, step) ||
        strncmp(message, step->id, strlen(step->id)) != 0) // of a file that is no step's
        return;
    choose_step(coach, (size_t)(step - step_table));
    *verdict = (Verdict){.state = VERDICT_ERROR};
    snprintf(verdict->message, sizeof verdict->message, "does not compile: %s", message);
}

bool coach_poll(Coach *coach)
{
    int status;
    if (!coach->judging)
        return false;
    if (coach->judge.process.pid <= 0) {
        judge_next(coach);
        return false;
    }
    if (!job_poll(&coach->judge, LONGEST, &status))
        return false;
    take_verdict(coach);
    const StepInfo *step = &step_table[coach->judged];
    const Verdict *verdict = &coach->verdicts.steps[coach->judged];
    printf("judged: %s %s %s\n", step->id, verdict_marks[verdict->state],
           verdict->message[0] ? verdict->message : step->title);
    return true;
}

const StepInfo *coach_go_to(Coach *coach, size_t step)
{
    if (!coach->judging)
        return NULL;
    choose_step(coach, step);
    return &step_table[step];
}

const StepInfo *coach_next(Coach *coach)
{
    return coach_go_to(coach, verdicts_next(&coach->verdicts));
}

void coach_hint(Coach *coach)
{
    Verdicts *verdicts = &coach->verdicts;
    int *given = &coach->hints[verdicts->present];
    Error error = {""};
    if (!coach->judging)
        return;
    *given = *given < HINT_COUNT ? *given + 1 : 1;
    char *hint = step_hint(&step_table[verdicts->present], *given, &error);
    snprintf(verdicts->hint, sizeof verdicts->hint, "hint %d of %d: %.1100s", *given, HINT_COUNT,
             hint ? hint : error.message);
    free(hint);
}
