#include "preview/watch/coach.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool coach_start(Coach *coach, const char *command, int stage, int stages)
{
    *coach = (Coach){.stage = stage, .verdicts = {.count = step_count_of(stages)}};
    return !command || (coach->judging = judging_start(command));
}

void coach_stop(Coach *coach)
{
    judging_stop(coach->judging);
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
            judging_want(coach->judging, verdicts, i, false);
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
    judging_want(coach->judging, &coach->verdicts, (size_t)(step - step_table), true);
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
    const StepInfo *step = coach->judging ? judging_poll(coach->judging, &coach->verdicts) : NULL;
    if (!step)
        return false;
    const Verdict *verdict = &coach->verdicts.steps[step - step_table];
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
