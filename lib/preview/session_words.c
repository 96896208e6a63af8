// What the line at the bottom says.
#include "preview/session.h"

#include <stdio.h>
#include <string.h>

// Appends "title 1.1 1.3 " with the ids of the steps in this state that play.
static void list_steps(const Scatter *scatter, StepState state, const char *title, char *text, size_t size)
{
    bool any = false;
    for (size_t i = 0; i < STEP_COUNT; i++) {
        if (scatter->states[i] != state || !step_is_played(&step_table[i], scatter->play))
            continue;
        size_t length = strlen(text);
        snprintf(text + length, size - length, "%s%s", any ? " " : title, step_table[i].id);
        any = true;
    }
}

void session_status(const Session *session, char *text, size_t size)
{
    const Scatter *scatter = side_scatter(session_yours(session));
    int passes = 0;
    if (session->scatter[YOURS] && scatter->emitted == 0)
        snprintf(text, size, "the first photons are on their way");
    else
        snprintf(text, size, "%ld photons, %zu stored, up to %d bounces", scatter->emitted, scatter->count,
                 scatter->bounces);
    size_t length = strlen(text);
    if (session->timed && scatter->emitted > 0)
        length += (size_t)snprintf(text + length, size - length, ", %.2f s", scatter->seconds);
    if (session->render && run_image(session->render, &passes))
        snprintf(text + length, size - length, " | rendered: %d pass%s", passes, passes == 1 ? "" : "es");
    if (session->options->code) {
        list_steps(scatter, STEP_STUDENT, " | your code: ", text, size);
        list_steps(scatter, STEP_NOT_STARTED, " | not started: ", text, size);
    } else {
        length = strlen(text);
        snprintf(text + length, size - length, " | the reference plays");
    }
    length = strlen(text);
    snprintf(text + length, size - length, "%s%s",
             session->building   ? " | building"
             : session->build[0] ? " | "
                                 : "",
             session->building ? "" : session->build);
}

void session_banner(const Session *session, char *text, size_t size)
{
    const char *const lines[] = {session->fault, session->warning, session->notice};
    text[0] = '\0';
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        size_t length = strlen(text);
        if (lines[i][0])
            snprintf(text + length, size - length, "%s%s", length > 0 ? "\n" : "", lines[i]);
    }
}
