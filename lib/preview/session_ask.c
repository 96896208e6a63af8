// What is asked of the helper processes: photons, findings, and pictures, anew when something else is looked at.
#include "preview/session.h"
#include "base/parallel.h"

#include <stdio.h>
#include <string.h>

#define FIRST_LOOK 0.12 // s after the request: photons of a slow scene are shown while the rest is on its way
#define MOST_WAIT  1.0  // s for the first of a picture, while the camera moves on

void session_stop(Run **run)
{
    run_free(*run);
    *run = NULL;
}

void session_drop(Session *session, RunKind kind, int player)
{
    session->have[kind][player] = false;
    session_stop(&session->runs[kind][player]);
}

void session_ask(Session *session, RunKind kind, int player)
{
    Error error = {""};
    Run **run = &session->runs[kind][player];
    const View *view = session->view;
    const double *lobe = view->settings[VIEW_LOBE];
    const Recording *yours = view_data_recording(session->data[YOURS]);
    Area area = view_area(session->canvas, view);
    RunRequest request = session->asked;
    request.kind = kind;
    request.code = player == YOURS ? session->options->code : NULL;
    // Beside a student who has come as far as 1.5 and 2.3, the reference plays those, too: like against like.
    if (player == REFERENCE && !request.play_is_given && yours->emitted > 0) {
        request.play_is_given = true;
        request.play = yours->play;
    }
    request.exponent = (float)lobe[LOBE_EXPONENT];
    request.angle = (float)lobe[LOBE_ANGLE];
    request.diffuse = lobe[LOBE_DIFFUSE] != 0.0;
    request.camera = orbit_camera(&view->orbit);
    request.width = area.width / (view->split ? PLAYERS : 1);
    request.height = area.height;
    if (kind == RUN_PHOTONS && player == YOURS) {
        session->coming = session->answered = false;
        session->next_look = clock_seconds() + FIRST_LOOK;
    }
    session_stop(run);
    *run = run_start(session->broker, &request, &error);
    if (!*run)
        snprintf(session->fault, sizeof session->fault, "%s", error.message);
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
    session_ask(session, RUN_PHOTONS, YOURS);
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
        if ((i == YOURS || session->view->split) && !session->have[kind][i] && !session->runs[kind][i])
            session_ask(session, kind, i);
    }
}

// True: it is not what the last picture was asked of.
static bool note_what_is_seen(Session *session)
{
    Area area = view_area(session->canvas, session->view);
    Seen now = {session->view->orbit, area.width, area.height, session->view->split};
    bool changed = memcmp(&now, &session->seen, sizeof now) != 0;
    session->seen = now;
    return changed;
}

void session_render(Session *session)
{
    session->rendering = true;
    session->render_started = clock_seconds();
    note_what_is_seen(session);
    for (int i = 0; i < PLAYERS; i++) {
        Run *run = session->runs[RUN_RENDER][i];
        if (run && run_image(run, NULL)) {
            image_free(&session->kept[i]);
            session->kept[i] = run_take_image(run);
        }
        session_drop(session, RUN_RENDER, i);
        if (i == YOURS || session->view->split)
            session_ask(session, RUN_RENDER, i);
    }
}

void session_stop_render(Session *session)
{
    session->rendering = false;
    for (int i = 0; i < PLAYERS; i++) {
        session_drop(session, RUN_RENDER, i);
        image_free(&session->kept[i]);
    }
}

// One that is asked for again and again would never come: the first of it is waited for.
static void need_render(Session *session)
{
    const Run *run = session->runs[RUN_RENDER][YOURS];
    bool come = !run || run_image(run, NULL) || clock_seconds() - session->render_started > MOST_WAIT;
    if (session->rendering && come && note_what_is_seen(session))
        session_render(session);
}

void session_need(Session *session)
{
    Run **runs = session->runs[RUN_PHOTONS];
    bool yours_known = view_data_recording(session->data[YOURS])->emitted > 0 && !runs[YOURS];
    if (session->view->split && yours_known && !session->have[RUN_PHOTONS][REFERENCE] && !runs[REFERENCE])
        session_ask(session, RUN_PHOTONS, REFERENCE);
    if (view_type(session->view)->shows != RUN_PHOTONS)
        need_findings(session, view_type(session->view)->shows);
    need_render(session);
}

void session_next_way(Session *session)
{
    static const struct {
        Integrator integrator;
        RadiiRule radii;
    } WAYS[] = {{INTEGRATOR_PHOTONS, RADII_ALIKE},
                {INTEGRATOR_GATHER, RADII_ALIKE},
                {INTEGRATOR_PHOTONS, RADII_BY_PASS},
                {INTEGRATOR_PHOTONS, RADII_BY_PIXEL},
                {INTEGRATOR_PHOTONS_ONLY, RADII_ALIKE}};
    enum { WAY_COUNT = sizeof WAYS / sizeof *WAYS };
    RunRequest *asked = &session->asked;
    int next = 0;
    for (int i = 0; i < WAY_COUNT; i++)
        if (WAYS[i].integrator == asked->integrator && WAYS[i].radii == asked->radii)
            next = (i + 1) % WAY_COUNT;
    asked->integrator = WAYS[next].integrator;
    asked->radii = WAYS[next].radii;
    if (session->rendering)
        session_render(session);
}
