// What is asked of the helper processes.
#include "preview/session.h"
#include "base/parallel.h"

#include <stdio.h>
#include <string.h>

#define LOBE_SAMPLES 20000
#define FIRST_LOOK   0.12 // s after the request: photons of a slow scene are shown while the rest is on its way

void session_stop(Run **run)
{
    if (*run)
        run_free(*run);
    *run = NULL;
}

void session_drop(Session *session, RunKind kind, int player)
{
    session->have[kind][player] = false;
    session_stop(&session->runs[kind][player]);
}

RunRequest session_request(const Session *session, int player, RunKind kind)
{
    const PreviewOptions *options = session->options;
    const Recording *yours = view_data_recording(session->data[YOURS]);
    RunRequest request = {
        .kind = kind,
        .code = player == YOURS ? options->code : NULL,
        .play_is_given = options->play_is_given,
        .play = options->play,
        .spectral = session->spectral,
        .seed = session->seed,
        .photons = session->photons,
        .depth = options->depth,
        .recorded = options->recorded,
        .samples = LOBE_SAMPLES,
    };
    // Beside a student who has come as far as 1.5 and 2.3, the reference plays those, too: like against like.
    if (player == REFERENCE && !options->play_is_given && yours->emitted > 0) {
        request.play_is_given = true;
        request.play = yours->play;
    }
    return request;
}

void session_start_run(Session *session, int player, const RunRequest *request)
{
    Error error = {""};
    Run **run = &session->runs[request->kind][player];
    session_stop(run);
    *run = run_start(session->broker, request, &error);
    if (!*run)
        snprintf(session->fault, sizeof session->fault, "%s", error.message);
}

void session_ask_player(Session *session, int player)
{
    if (player == YOURS) {
        session->coming = session->answered = false;
        session->next_look = clock_seconds() + FIRST_LOOK;
    }
    RunRequest request = session_request(session, player, RUN_PHOTONS);
    session_start_run(session, player, &request);
}

void session_ask_photons(Session *session)
{
    session->asked_by = view_data_recording(session->data[YOURS])->emitted > 0 ? "key" : "start";
    session->asked_at = clock_seconds();
    session_drop(session, RUN_PHOTONS, REFERENCE);
    for (int i = 0; i < PLAYERS; i++) { // those are made of photons, too
        session_drop(session, RUN_ESTIMATES, i);
        session_drop(session, RUN_DISKS, i);
    }
    session_ask_player(session, YOURS);
}

// What the lobe's samples depend on.
static void ask_lobe(const Session *session, RunRequest *request)
{
    const double *settings = session->view->settings[VIEW_LOBE];
    request->exponent = (float)settings[LOBE_EXPONENT];
    request->angle = (float)settings[LOBE_ANGLE];
    request->diffuse = settings[LOBE_DIFFUSE] != 0.0;
}

// Findings of the kind that the view shows.
static void need_findings(Session *session, RunKind kind)
{
    const double *settings = session->view->settings[VIEW_LOBE];
    bool changed = kind == RUN_LOBE && memcmp(session->lobe, settings, sizeof session->lobe) != 0;
    if (kind == RUN_LOBE)
        memcpy(session->lobe, settings, sizeof session->lobe);
    for (int i = 0; i < PLAYERS; i++) {
        if (changed)
            session_drop(session, kind, i);
        if ((i == REFERENCE && !session->view->split) || session->have[kind][i] || session->runs[kind][i])
            continue;
        RunRequest request = session_request(session, i, kind);
        ask_lobe(session, &request);
        session_start_run(session, i, &request);
    }
}

void session_need(Session *session)
{
    Run **runs = session->runs[RUN_PHOTONS];
    bool yours_known = view_data_recording(session->data[YOURS])->emitted > 0 && !runs[YOURS];
    if (session->view->split && yours_known && !session->have[RUN_PHOTONS][REFERENCE] && !runs[REFERENCE])
        session_ask_player(session, REFERENCE);
    if (view_type(session->view)->shows != RUN_PHOTONS)
        need_findings(session, view_type(session->view)->shows);
    session_need_render(session);
}
