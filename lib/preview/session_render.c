// Pictures: where, how, and anew when something else is looked at.
#include "preview/session.h"
#include "base/parallel.h"

#include <string.h>

#define MOST_WAIT 1.0 // s for the first of a picture, while the camera moves on

// Zeroed first: it is compared byte by byte.
static void note_what(Session *session)
{
    Area area = view_area(session->canvas, session->view);
    memset(&session->rendered, 0, sizeof session->rendered);
    session->rendered.orbit = session->view->orbit;
    session->rendered.width = area.width;
    session->rendered.height = area.height;
    session->rendered.split = session->view->split;
}

static void keep_image(Session *session, int player)
{
    Run *run = session->runs[RUN_RENDER][player];
    Image image = run ? run_take_image(run) : (Image){0, 0, NULL};
    if (!image.pixels)
        return;
    image_free(&session->kept[player]);
    session->kept[player] = image;
}

void session_render(Session *session)
{
    int parts = session->view->split ? PLAYERS : 1;
    session->rendering = true;
    session->render_started = clock_seconds();
    note_what(session);
    for (int i = 0; i < PLAYERS; i++) {
        keep_image(session, i);
        session_drop(session, RUN_RENDER, i);
    }
    for (int i = 0; i < parts; i++) {
        RunRequest request = session_request(session, i, RUN_RENDER);
        request.integrator = session->integrator;
        request.radii = session->radii;
        request.passes = session->most_passes;
        request.camera = orbit_camera(&session->rendered.orbit);
        request.width = session->rendered.width / parts;
        request.height = session->rendered.height;
        session_start_run(session, i, &request);
    }
}

// One that is asked for again and again would never come: the first of it is waited for.
void session_need_render(Session *session)
{
    int passes;
    const Run *run = session->runs[RUN_RENDER][YOURS];
    if (!session->rendering)
        return;
    Session now = {.view = session->view, .canvas = session->canvas};
    note_what(&now);
    bool come = !run || run_image(run, &passes) || clock_seconds() - session->render_started > MOST_WAIT;
    if (come && memcmp(&now.rendered, &session->rendered, sizeof now.rendered) != 0)
        session_render(session);
}

void session_stop_render(Session *session)
{
    session->rendering = false;
    for (int i = 0; i < PLAYERS; i++) {
        session_drop(session, RUN_RENDER, i);
        image_free(&session->kept[i]);
    }
}

const Image *session_image(const Session *session, int player)
{
    int passes;
    const Run *run = session->runs[RUN_RENDER][player];
    const Image *image = run ? run_image(run, &passes) : NULL;
    if (image || !session->rendering || (player == REFERENCE && !session->view->split))
        return image;
    return session->kept[player].pixels ? &session->kept[player] : NULL;
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
    int next = 0;
    for (int i = 0; i < WAY_COUNT; i++)
        if (WAYS[i].integrator == session->integrator && WAYS[i].radii == session->radii)
            next = (i + 1) % WAY_COUNT;
    session->integrator = WAYS[next].integrator;
    session->radii = WAYS[next].radii;
    if (session->rendering)
        session_render(session);
}
