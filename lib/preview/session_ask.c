// What is asked of the helper processes.
#include "preview/session.h"
#include "base/parallel.h"

#include <stdio.h>

#define LOBE_SAMPLES 10000
#define FIRST_LOOK   0.12 // s after the request: photons of a slow scene are shown while the rest is on its way

void session_stop(Run **run)
{
    if (*run)
        run_free(*run);
    *run = NULL;
}

static RunRequest request_for(const Session *session, int side, RunKind kind)
{
    const PreviewOptions *options = session->options;
    const Recording *yours = side_recording(session->sides[YOURS]);
    RunRequest request = {
        .kind = kind,
        .code = side == YOURS ? options->code : NULL,
        .play_is_given = options->play_is_given,
        .play = options->play,
        .seed = session->seed,
        .photons = session->photons,
        .depth = options->depth,
        .recorded = options->recorded,
        .samples = LOBE_SAMPLES,
    };
    // Beside a student who has come as far as 1.5 and 2.3, the reference plays those, too: like against like.
    if (side == REFERENCE && !options->play_is_given && yours->emitted > 0) {
        request.play_is_given = true;
        request.play = yours->play;
    }
    return request;
}

static void start(Session *session, Run **run, const RunRequest *request)
{
    Error error = {""};
    session_stop(run);
    *run = run_start(session->broker, request, &error);
    if (!*run)
        snprintf(session->fault, sizeof session->fault, "%s", error.message);
}

void session_ask_side(Session *session, int side)
{
    if (side == YOURS) {
        session->coming = session->answered = false;
        session->next_look = clock_seconds() + FIRST_LOOK;
    }
    RunRequest request = request_for(session, side, RUN_PHOTONS);
    start(session, &session->tracing[side], &request);
}

static void start_lobe(Session *session, const View *view, int side)
{
    RunRequest request = request_for(session, side, RUN_LOBE);
    request.exponent = view->exponent;
    request.angle = view->angle;
    request.diffuse = view->diffuse;
    start(session, &session->lobe[side], &request);
}

void session_ask_photons(Session *session, const View *view)
{
    session->asked_by = side_recording(session->sides[YOURS])->emitted > 0 ? "key" : "start";
    session->asked_at = clock_seconds();
    session->have_reference = false;
    session_stop(&session->tracing[REFERENCE]);
    session_ask_side(session, YOURS);
    session_need(session, view);
}

void session_need(Session *session, const View *view)
{
    bool yours_known = side_recording(session->sides[YOURS])->emitted > 0 && !session->tracing[YOURS];
    if (view->split && yours_known && !session->have_reference && !session->tracing[REFERENCE])
        session_ask_side(session, REFERENCE);
    for (int i = 0; i < RUN_SIDES; i++)
        if (view->kind == VIEW_LOBE && (i == YOURS || view->split) && !session->have_lobe[i] && !session->lobe[i])
            start_lobe(session, view, i);
}

void session_lobe_changed(Session *session, const View *view)
{
    for (int i = 0; i < RUN_SIDES; i++) {
        session->have_lobe[i] = false;
        session_stop(&session->lobe[i]);
    }
    session_need(session, view);
}

void session_render(Session *session, const View *view, int width, int height)
{
    session->render_width = width;
    session->render_height = height;
    RunRequest request = request_for(session, YOURS, RUN_RENDER);
    request.camera = orbit_camera(&view->orbit);
    request.width = width;
    request.height = height;
    start(session, &session->render, &request);
}

void session_stop_render(Session *session)
{
    session_stop(&session->render);
}
