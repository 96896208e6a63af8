// How the steps are: each save is judged, and one step is the present one.
#include "preview/session.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Of the stage that was asked for, the first step that is not started; otherwise of all, or the first.
static size_t first_open(const Session *session, const Recording *recording)
{
    size_t first = STEP_COUNT;
    for (size_t i = 0; i < STEP_COUNT; i++) {
        bool open = recording->states[i] != STEP_STUDENT;
        bool of_stage = session->options->stage == 0 || step_table[i].stage == session->options->stage;
        if (open && of_stage)
            return i;
        first = first == STEP_COUNT && of_stage ? i : first;
    }
    return first < STEP_COUNT ? first : 0;
}

void session_note_states(Session *session, const Recording *recording)
{
    Verdicts *verdicts = &session->verdicts;
    if (!session->judging)
        return;
    for (size_t i = 0; i < STEP_COUNT; i++) {
        Verdict *verdict = &verdicts->steps[i];
        if (recording->states[i] != STEP_STUDENT && verdict->state != VERDICT_ERROR)
            *verdict = (Verdict){.state = VERDICT_TODO};
        else if (verdict->state == VERDICT_NONE && !verdict->judged_now)
            judging_want(session->judging, verdicts, i, false);
    }
    if (!session->stated)
        verdicts->present = first_open(session, recording);
    session->stated = true;
}

static void choose_step(Session *session, size_t step)
{
    session->verdicts.present = step;
    session->verdicts.hint[0] = '\0';
}

void session_judge(Session *session, const StepInfo *step)
{
    if (!session->judging || !session->stated) // all that are started will be
        return;
    choose_step(session, (size_t)(step - step_table));
    judging_want(session->judging, &session->verdicts, (size_t)(step - step_table), true);
}

void session_note_broken(Session *session, const StepInfo *step, const char *message)
{
    Verdict *verdict = &session->verdicts.steps[step - step_table];
    if (!session->judging || strncmp(message, step->id, strlen(step->id)) != 0) // of a file that is no step's
        return;
    choose_step(session, (size_t)(step - step_table));
    *verdict = (Verdict){.state = VERDICT_ERROR};
    snprintf(verdict->message, sizeof verdict->message, "does not compile: %s", message);
}

bool session_poll_judge(Session *session)
{
    const StepInfo *step = session->judging ? judging_poll(session->judging, &session->verdicts) : NULL;
    if (!step)
        return false;
    const Verdict *verdict = &session->verdicts.steps[step - step_table];
    printf("judged: %s %s %s\n", step->id, verdict_marks[verdict->state],
           verdict->message[0] ? verdict->message : step->title);
    return true;
}

void session_next_step(Session *session)
{
    if (!session->judging)
        return;
    choose_step(session, verdicts_next(&session->verdicts));
    int stage = step_table[session->verdicts.present].stage;
    if (session->stage > 0 && stage != session->stage) { // each has a scene in which its steps show
        session->stage = stage;
        session_load_scene(session, stage_scenes[stage - 1]);
    }
    printf("the present step: %s/%s.c\n", session->options->source, step_table[session->verdicts.present].file);
}

void session_hint(Session *session)
{
    Verdicts *verdicts = &session->verdicts;
    int *given = &session->hints[verdicts->present];
    Error error = {""};
    if (!session->judging)
        return;
    *given = *given < HINT_COUNT ? *given + 1 : 1;
    char *hint = step_hint(&step_table[verdicts->present], *given, &error);
    snprintf(verdicts->hint, sizeof verdicts->hint, "hint %d of %d: %.1100s", *given, HINT_COUNT,
             hint ? hint : error.message);
    free(hint);
}
