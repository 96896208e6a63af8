// What the session says around the picture, and drawing both.
#include "preview/session.h"
#include "preview/record/rendered.h"
#include "base/text.h"

#include <stdio.h>
#include <stdlib.h>
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
        text_append(text, size, "%s%s", any ? " " : title, step_table[i].id);
        any = true;
    }
    return any;
}

static void describe_render(const Session *session, char *text, size_t size)
{
    const Run *render = session->runs[RUN_RENDER][YOURS];
    static const char *const RADII[RADII_RULES] = {"", ", radii shrink by pass", ", radii shrink by pixel"};
    int passes = 0;
    if (render)
        run_image(render, &passes);
    snprintf(text, size, "rendered by %s%s%s: ", integrator_names[session->asked.integrator],
             session->asked.spectral ? ", in wavelengths" : "", RADII[session->asked.radii]);
    if (passes > 0)
        text_append(text, size, "%d pass%s", passes, passes == 1 ? "" : "es");
    else
        text_append(text, size, "a first look");
}

// The line at the bottom.
static void list_status(const Session *session, char *text, size_t size)
{
    const Recording *recording = view_data_recording(session_yours(session));
    text[0] = '\0';
    if (session->runs[RUN_PHOTONS][YOURS] && recording->emitted == 0)
        text_append(text, size, "the first photons are on their way");
    else
        text_append(text, size, "%ld photons, %zu stored, up to %d bounces", recording->emitted, recording->count,
                    recording->bounces);
    if (session->timed && recording->emitted > 0)
        text_append(text, size, ", %.2f\u00a0s", recording->seconds);
    if (session->coach.judging) { // the panel has the rest
        list_steps(recording, true, false, " | built, not played: ", text, size);
    } else if (session->options->code) {
        if (!list_steps(recording, true, true, " | your code: ", text, size))
            text_append(text, size, " | your code: nothing yet");
        list_steps(recording, true, false, " | built, not played: ", text, size);
        list_steps(recording, false, true, " | the reference: ", text, size);
    } else {
        text_append(text, size, " | the reference plays");
    }
    if (session->building || (session->build[0] && strcmp(session->build, session->fault) != 0)) // the banner has it
        text_append(text, size, " | %s", session->building ? "building" : session->build);
    if (session->timed)
        text_append(text, size, "\n%sh: keys", session->coach.judging ? "n: next step   ?: hint   " : "");
}

bool session_is_faulty(const Session *session)
{
    return session->scene_fault[0] || session->fault[0] || session->warning[0] || session->notice[0];
}

// What is wrong, a line each: of the scene, the fault, what the compiler warned of, what right steps never do. "": nothing.
static void list_faults(const Session *session, char *text, size_t size)
{
    bool behind = session->behind && session->fault[0] && view_data_recording(session_yours(session))->emitted > 0;
    const char *const lines[] = {session->scene_fault, session->fault, session->warning,
                                 behind ? "The photons are still those of the save before." : session->notice};
    text[0] = '\0';
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++)
        if (lines[i][0])
            text_append(text, size, "%s%s", text[0] ? "\n" : "", lines[i]);
}

// What a run renders, or the one before it did, as sRGB in memory of its own. None: nothing yet, or memory is short.
static Picture picture_of(const Session *session, int player)
{
    const Run *run = session->runs[RUN_RENDER][player];
    const Image *image = run ? run_image(run, NULL) : NULL;
    bool wanted = session->rendering && (player == YOURS || session->view->split);
    if (!image && wanted && session->kept[player].pixels)
        image = &session->kept[player];
    uint8_t *bytes = image ? rendered_rgba(image, view_brightness(session->view)) : NULL;
    return bytes ? (Picture){bytes, image->width, image->height} : (Picture){NULL, 0, 0};
}

void session_draw(const Session *session, const View *view, const char *help)
{
    char status[700], banner[2000], rendered[200];
    describe_render(session, rendered, sizeof rendered);
    list_status(session, status, sizeof status);
    list_faults(session, banner, sizeof banner);
    Captions captions = {.help = help,
                         .banner = banner,
                         .banner_is_old = session->building,
                         .rendered = rendered,
                         .verdicts = session->coach.judging ? &session->coach.verdicts : NULL,
                         .source = session->options->source};
    captions.status = session->options->given[YOURS] ? NULL : status;
    for (int i = 0; i < PLAYERS; i++)
        captions.pictures[i] = picture_of(session, i);
    view_draw(session->canvas, view, session_yours(session), session->data[REFERENCE], &captions);
    for (int i = 0; i < PLAYERS; i++)
        free((void *)captions.pictures[i].rgba);
}
