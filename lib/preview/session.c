#include "preview/session.h"
#include "base/parallel.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#define NEXT_LOOK  0.4
#define SCENE_LOOK 1.0

bool session_start(Session *session, const Scene *scene, const PreviewOptions *options, Broker *broker, Canvas *canvas,
                   Error *error)
{
    *session = (Session){.scene = scene, .options = options, .broker = broker};
    session->photons = options->photons;
    session->seed = options->seed;
    for (int i = 0; i < SIDES; i++)
        if (!(session->sides[i] = side_create(canvas, scene)))
            return error_set(error, "not enough memory for the preview");
    if (!options->source || !options->build)
        return true;
    session->watch = watch_start(options->source, options->code, options->build, error);
    return session->watch != NULL;
}

void session_end(Session *session)
{
    for (int i = 0; i < RUN_SIDES; i++) {
        session_stop(&session->tracing[i]);
        session_stop(&session->lobe[i]);
    }
    for (int i = 0; i < SIDES; i++)
        if (session->sides[i])
            side_free(session->sides[i]);
    session_stop(&session->render);
    if (session->watch)
        watch_stop(session->watch);
}

static void tell(const char *text)
{
    printf("%s\n", text);
    fflush(stdout);
}

static void fault(Session *session, const char *text)
{
    if (strcmp(session->fault, text) == 0)
        return;
    snprintf(session->fault, sizeof session->fault, "%s", text);
    tell(text);
}

// A save: its objects are there, so ask again for everything that the student's code made.
static void rebuilt(Session *session, const View *view)
{
    session->fault[0] = session->notice[0] = '\0'; // to be told again if they are still there
    session->have_lobe[YOURS] = false;
    session_stop(&session->lobe[YOURS]);
    session_ask_side(session, YOURS);
    session->asked_by = "save";
    session->after_save = true; // until the window has shown it
    if (session->render)
        session_render(session, view, session->render_width, session->render_height);
}

static bool poll_watch(Session *session, const View *view)
{
    WatchEvent event = session->watch ? watch_poll(session->watch) : WATCH_NOTHING;
    if (event == WATCH_NOTHING)
        return false;
    if (!session->building)
        session->asked_at = clock_seconds();
    session->building = event == WATCH_BUILDING;
    if (event == WATCH_BUILDING) // nothing to see: drawing would only take the compiler's time
        return false;
    snprintf(session->build, sizeof session->build, "%s", watch_message(session->watch));
    if (event == WATCH_FAILED) {
        session->fault[0] = '\0'; // the same mistake after another save is told again
        fault(session, session->build);
        return true;
    }
    tell(session->build);
    snprintf(session->warning, sizeof session->warning, "%s", watch_warning(session->watch));
    if (session->warning[0])
        tell(session->warning);
    rebuilt(session, view);
    return false; // its photons are soon there
}

// A student saves, and nothing changes: another step does that work.
static void tell_if_not_played(Session *session, const Recording *recording)
{
    const StepInfo *step = session->after_save && session->watch ? watch_step(session->watch) : NULL;
    if (!step || recording->states[step - step_table] != STEP_STUDENT || step_is_played(step, recording->play))
        return;
    char text[300];
    snprintf(text, sizeof text,
             "%s is built, but another step plays in its place; make preview FLAGS=\"--steps %s\" plays it", step->id,
             step_chosen_by(step)->id);
    tell(text);
    size_t length = strlen(session->notice);
    snprintf(session->notice + length, sizeof session->notice - length, "%s%s", length > 0 ? "\n" : "", text);
}

static void take_photons(Session *session, int side, const RunStatus *status)
{
    side_set_recording(session->sides[side], run_take_recording(session->tracing[side]));
    if (side == REFERENCE) {
        session->have_reference = true;
        return;
    }
    if (strcmp(session->notice, status->notice) != 0 && status->notice[0])
        tell(status->notice);
    snprintf(session->notice, sizeof session->notice, "%s", status->notice);
    const Recording *recording = side_recording(session->sides[side]);
    tell_if_not_played(session, recording);
    // What another step's last build said is still true.
    snprintf(session->fault, sizeof session->fault, "%s", session->watch ? watch_broken(session->watch) : "");
    printf("%zu photons stored of %ld emitted, %.2f s after the %s\n", recording->count, recording->emitted,
           clock_seconds() - session->asked_at, session->asked_by);
    fflush(stdout);
    session->answered = true;
}

// The first photons of a run that takes its time.
static bool look_at_coming(Session *session)
{
    Recording part;
    if (clock_seconds() < session->next_look || !run_copy_partial(session->tracing[YOURS], &part))
        return false;
    side_set_recording(session->sides[COMING], part);
    session->coming = session->answered = true;
    session->next_look = clock_seconds() + NEXT_LOOK;
    return true;
}

static bool poll_photons(Session *session, int side)
{
    if (!session->tracing[side])
        return false;
    RunStatus status = run_poll(session->tracing[side]);
    if (status.state == RUN_GOING)
        return side == YOURS && look_at_coming(session);
    session->coming = session->coming && side != YOURS;
    if (status.state == RUN_FAILED)
        fault(session, status.failure);
    else
        take_photons(session, side, &status);
    // A reference that fails would fail again at once.
    session->have_reference = session->have_reference || side == REFERENCE;
    session_stop(&session->tracing[side]);
    return true;
}

static bool poll_lobe(Session *session, int side)
{
    if (!session->lobe[side])
        return false;
    RunStatus status = run_poll(session->lobe[side]);
    if (status.state == RUN_GOING)
        return false;
    if (status.state == RUN_FAILED)
        fault(session, status.failure);
    else
        side_set_lobe(session->sides[side], run_take_lobe(session->lobe[side]));
    session->have_lobe[side] = true;
    session_stop(&session->lobe[side]);
    return true;
}

static bool poll_render(Session *session)
{
    if (!session->render)
        return false;
    RunStatus status = run_poll(session->render);
    if (status.state != RUN_FAILED)
        return status.news;
    fault(session, status.failure);
    session_stop(&session->render);
    return true;
}

// The scene is read once, and the workers hold it.
static bool look_at_scene(Session *session)
{
    struct stat info;
    double now = clock_seconds();
    if (!session->watch || now - session->looked_at_scene < SCENE_LOOK ||
        stat(session->options->scene_path, &info) != 0)
        return false;
    session->looked_at_scene = now;
    long long before = session->scene_changed;
    session->scene_changed = (long long)info.st_mtime;
    if (before == 0 || before == session->scene_changed || session->scene_is_old)
        return false;
    session->scene_is_old = true;
    printf("%s was changed; start the preview again to see it\n", session->options->scene_path);
    fflush(stdout);
    return true;
}

bool session_poll(Session *session, const View *view)
{
    bool news = poll_watch(session, view);
    news |= look_at_scene(session);
    for (int i = 0; i < RUN_SIDES; i++) {
        news |= poll_photons(session, i);
        news |= poll_lobe(session, i);
    }
    news |= poll_render(session);
    session_need(session, view);
    return news;
}

bool session_is_busy(const Session *session)
{
    return session->building || session->tracing[YOURS] || session->tracing[REFERENCE] || session->lobe[YOURS] ||
           session->lobe[REFERENCE];
}

void session_wait(Session *session, double seconds)
{
    for (int i = 0; i < RUN_SIDES; i++) {
        if (session->tracing[i]) {
            run_wait(session->tracing[i], seconds);
            return;
        }
        if (session->lobe[i]) {
            run_wait(session->lobe[i], seconds);
            return;
        }
    }
    if (session->watch)
        watch_wait(session->watch, seconds);
}

Side *session_yours(const Session *session)
{
    return session->sides[session->coming ? COMING : YOURS];
}
