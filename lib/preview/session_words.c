// What the line at the bottom says.
#include "preview/session.h"

#include <stdio.h>
#include <string.h>

// Appends "title 1.1 1.3 " with the ids of the steps that are, or are not, the student's and play. False: there is none.
static bool list_steps(const Recording *recording, bool students, bool played, const char *title, char *text,
                       size_t size)
{
    bool any = false;
    for (size_t i = 0; i < STEP_COUNT; i++) {
        if ((recording->states[i] == STEP_STUDENT) != students ||
            step_is_played(&step_table[i], recording->play) != played)
            continue;
        size_t length = strlen(text);
        snprintf(text + length, size - length, "%s%s", any ? " " : title, step_table[i].id);
        any = true;
    }
    return any;
}

void session_status(const Session *session, char *text, size_t size)
{
    const Recording *recording = side_recording(session_yours(session));
    int passes = 0;
    if (session->tracing[YOURS] && recording->emitted == 0)
        snprintf(text, size, "the first photons are on their way");
    else
        snprintf(text, size, "%ld photons, %zu stored, up to %d bounces", recording->emitted, recording->count,
                 recording->bounces);
    size_t length = strlen(text);
    if (session->timed && recording->emitted > 0)
        length += (size_t)snprintf(text + length, size - length, ", %.2f s", recording->seconds);
    if (session->render && run_image(session->render, &passes))
        snprintf(text + length, size - length, " | rendered: %d pass%s", passes, passes == 1 ? "" : "es");
    if (session->options->code) {
        if (!list_steps(recording, true, true, " | your code: ", text, size)) {
            length = strlen(text);
            snprintf(text + length, size - length, " | your code: nothing yet");
        }
        list_steps(recording, true, false, " | built, not played: ", text, size);
        list_steps(recording, false, true, " | the reference: ", text, size);
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
    if (session->timed) {
        length = strlen(text);
        snprintf(text + length, size - length, " | h: keys");
    }
}

void session_banner(const Session *session, char *text, size_t size)
{
    const char *const scene =
        session->scene_is_old ? "the scene's file was changed; start the preview again to see it" : "";
    const char *const lines[] = {session->fault, session->warning, session->notice, scene};
    text[0] = '\0';
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        size_t length = strlen(text);
        if (lines[i][0])
            snprintf(text + length, size - length, "%s%s", length > 0 ? "\n" : "", lines[i]);
    }
}
