// The scene: loaded anew when its files change, and another one for another stage.
#include "preview/session.h"
#include "base/parallel.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SCENE_LOOK 0.7 // s

static uint64_t fingerprint(const Session *session)
{
    uint64_t sum = watch_fingerprint(0, session->scene_path);
    char *files = session->scene->mesh_files ? strdup(session->scene->mesh_files) : NULL, *rest = NULL;
    for (char *file = files ? strtok_r(files, "\n", &rest) : NULL; file; file = strtok_r(NULL, "\n", &rest))
        sum = watch_fingerprint(sum, file);
    free(files);
    return sum;
}

void session_choose_way(Session *session)
{
    const PreviewOptions *options = session->options;
    Integrator own = session->stage == 4 ? INTEGRATOR_GATHER : session->scene->settings.integrator;
    session->asked.integrator = options->integrator < 0 ? own : (Integrator)options->integrator;
    session->asked.radii = session->stage == 5 && options->radii == RADII_ALIKE ? RADII_BY_PASS : options->radii;
    session->asked.spectral = options->spectral || session->stage == 6;
}

// All that was made of the old one goes. False: memory is short, and nothing has changed.
static bool put_in_place(Session *session, Scene *scene, Broker *broker)
{
    ViewData *data[DATA_COUNT];
    for (int i = 0; i < DATA_COUNT; i++)
        if (!(data[i] = view_data_create(session->canvas, scene))) {
            while (i-- > 0)
                view_data_free(data[i]);
            return false;
        }
    for (int i = 0; i < DATA_COUNT; i++) {
        view_data_free(session->data[i]);
        session->data[i] = data[i];
    }
    broker_stop(session->own_broker);
    scene_free(session->own_scene);
    session->scene = session->own_scene = scene;
    session->broker = session->own_broker = broker;
    return true;
}

static bool take_scene(Session *session)
{
    Error error = {""};
    Scene *scene = scene_load(session->scene_path, &error);
    if (!scene)
        return session_tell(session->scene_fault, sizeof session->scene_fault, error.message);
    for (int kind = 0; kind < RUN_KINDS; kind++)
        for (int i = 0; i < PLAYERS; i++) // before the fork, which would keep their pipes
            session_drop(session, (RunKind)kind, i);
    Broker *broker = broker_start(scene, session->options->source, &error);
    if (!broker || !put_in_place(session, scene, broker)) {
        broker_stop(broker);
        scene_free(scene);
        return session_tell(session->scene_fault, sizeof session->scene_fault,
                            broker ? "not enough memory for the scene" : error.message);
    }
    session->scene_fault[0] = session->notice[0] = '\0';
    session_choose_way(session);
    session->scene_seen = fingerprint(session);
    session_ask_photons(session);
    session->asked_by = "change of the scene";
    if (session->rendering)
        session_render(session);
    return true;
}

bool session_look_at_scene(Session *session)
{
    double now = clock_seconds();
    if (!session->watch || now - session->looked_at_scene < SCENE_LOOK)
        return false;
    session->looked_at_scene = now;
    uint64_t seen = fingerprint(session);
    bool changed = session->scene_seen != 0 && seen != session->scene_seen;
    session->scene_seen = seen;
    // What cannot be read is tried again: a mesh that it names may come.
    return (changed || session->scene_fault[0]) && take_scene(session);
}

void session_show_step(Session *session, const StepInfo *step)
{
    if (!step)
        return;
    if (session->stage > 0 && step->stage != session->stage) { // each has a scene in which its steps show
        const char *before = session->scene_path;
        session->stage = step->stage;
        session->scene_path = stage_scenes[step->stage - 1];
        take_scene(session);
        if (session->scene_fault[0])
            session->scene_path = before;
    }
    printf("the present step: %s/%s.c\n", session->options->source, step->file);
}
