#include "preview/session.h"
#include "base/parallel.h"
#include "base/text.h"
#include "preview/record/fault.h"

#include <stdio.h>
#include <string.h>

#define LOBE_SAMPLES 20000
#define NEXT_LOOK    0.4 // s

bool session_start(Session *session, const Scene *scene, const PreviewOptions *options, const View *view,
                   Broker *broker, Canvas *canvas, Error *error)
{
    *session = (Session){.options = options, .view = view, .broker = broker, .canvas = canvas, .scene = scene};
    session->scene_path = options->scene_path;
    session->asked = (RunRequest){.play_is_given = options->play_is_given,
                                  .play = options->play,
                                  .seed = options->seed,
                                  .photons = options->photons,
                                  .depth = options->depth,
                                  .recorded = options->recorded,
                                  .samples = LOBE_SAMPLES};
    session->stage = options->stage;
    session_choose_way(session);
    for (int i = 0; i < DATA_COUNT; i++)
        if (!(session->data[i] = view_data_create(canvas, scene)))
            return error_set(error, "not enough memory for the preview");
    if (!canvas_has_letters() && view->panel > 0.0f)
        puts("no font, so no words in the picture; Debian, Ubuntu: apt-get install fonts-dejavu-core");
    if (options->source && options->build &&
        !(session->watch = watch_start(options->source, options->code, options->build, error)))
        return false;
    coach_start(&session->coach, session->watch ? options->judge : NULL, options->stage, options->stages);
    if (!options->given[YOURS])
        session_ask_photons(session);
    return true;
}

void session_end(Session *session)
{
    session_stop_render(session);
    for (int kind = 0; kind < RUN_KINDS; kind++)
        for (int i = 0; i < PLAYERS; i++)
            session_stop(&session->runs[kind][i]);
    for (int i = 0; i < DATA_COUNT; i++)
        view_data_free(session->data[i]);
    broker_stop(session->own_broker);
    scene_free(session->own_scene);
    coach_stop(&session->coach);
    watch_stop(session->watch);
}

bool session_tell(char *kept, size_t size, const char *text)
{
    if (strcmp(kept, text) == 0)
        return false;
    snprintf(kept, size, "%s", text);
    if (text[0])
        puts(kept);
    return true;
}

// A save: its objects are there, so ask again for everything that the student's code made.
static void rebuilt(Session *session)
{
    session->fault[0] = session->notice[0] = '\0'; // to be told again if they are still there
    for (int kind = RUN_LOBE; kind < RUN_RENDER; kind++)
        session_drop(session, (RunKind)kind, YOURS);
    session_ask(session, RUN_PHOTONS, YOURS);
    session->asked_by = "save";
    session->after_save = true; // until the window has shown it
    if (session->rendering)
        session_render(session);
}

static bool poll_watch(Session *session)
{
    WatchEvent event = session->watch ? watch_poll(session->watch) : WATCH_NOTHING;
    if (event == WATCH_NOTHING)
        return false;
    if (!session->building)
        session->asked_at = clock_seconds();
    session->building = event == WATCH_BUILDING;
    if (event == WATCH_BUILDING) // else nothing to see: drawing would only take the compiler's time
        return session_is_faulty(session);
    snprintf(session->build, sizeof session->build, "%s", watch_message(session->watch));
    snprintf(session->warning, sizeof session->warning, "%s", watch_warning(session->watch));
    if (event == WATCH_FAILED) {
        session->fault[0] = '\0'; // the same mistake after another save is told again
        session->behind = true;
        session_tell(session->fault, sizeof session->fault, session->build);
        coach_note_broken(&session->coach, watch_step(session->watch), session->build);
        return true;
    }
    puts(session->build);
    if (session->warning[0])
        puts(session->warning);
    rebuilt(session);
    coach_judge(&session->coach, watch_step(session->watch));
    return false; // its photons are soon there: to draw now would keep them waiting
}

static void tell_if_not_played(Session *session, const Recording *recording)
{
    bool saved = session->watch && strcmp(session->asked_by, "save") == 0;
    const StepInfo *step = saved ? watch_step(session->watch) : NULL;
    char text[300];
    if (!step || !fault_describe_unplayed(recording, step, "make preview", text, sizeof text))
        return;
    puts(text);
    text_append(session->notice, sizeof session->notice, "%s%s", session->notice[0] ? "\n" : "", text);
}

static void take_photons(Session *session, const RunStatus *status)
{
    session_tell(session->notice, sizeof session->notice, status->notice);
    const Recording *recording = view_data_recording(session->data[YOURS]);
    tell_if_not_played(session, recording);
    coach_note_states(&session->coach, recording->states);
    // What another step's last build said is still true.
    snprintf(session->fault, sizeof session->fault, "%s", session->watch ? watch_broken(session->watch) : "");
    printf("%zu photons stored of %ld emitted, %.2f s after the %s\n", recording->count, recording->emitted,
           clock_seconds() - session->asked_at, session->asked_by);
    session->answered = true;
    session->behind = false;
}

// The first photons of a run that takes its time.
static bool look_at_coming(Session *session)
{
    Recording part;
    if (clock_seconds() < session->next_look || !run_copy_partial(session->runs[RUN_PHOTONS][YOURS], &part))
        return false;
    view_data_record(session->data[COMING], part);
    session->coming = session->answered = true;
    session->next_look = clock_seconds() + NEXT_LOOK;
    return true;
}

// While a file does not compile, what was built before goes on, and may fail as well.
static void run_failed(Session *session, RunKind kind, int player, const char *failure)
{
    const char *broken = session->watch ? watch_broken(session->watch) : "";
    char text[sizeof session->fault];
    snprintf(text, sizeof text, "%s%s%s", broken, broken[0] ? "\nas it was before: " : "", failure);
    session_tell(session->fault, sizeof session->fault, text);
    session->behind = session->behind || (kind == RUN_PHOTONS && player == YOURS);
}

static bool poll_run(Session *session, RunKind kind, int player)
{
    Run **run = &session->runs[kind][player];
    if (!*run)
        return false;
    RunStatus status = run_poll(*run);
    bool of_yours = kind == RUN_PHOTONS && player == YOURS;
    if (kind == RUN_RENDER && status.state != RUN_FAILED) {
        session->have[kind][player] = status.state == RUN_DONE;
        return status.news;
    }
    if (status.state == RUN_GOING)
        return of_yours && look_at_coming(session);
    session->coming = session->coming && !of_yours;
    session->have[kind][player] = true; // a failure, too: it would fail again at once
    if (status.state == RUN_FAILED)
        run_failed(session, kind, player, status.failure);
    else if (kind == RUN_PHOTONS)
        view_data_record(session->data[player], run_take_recording(*run));
    else
        view_data_find(session->data[player], kind, run_take_findings(*run));
    if (of_yours && status.state == RUN_DONE)
        take_photons(session, &status);
    session_stop(run);
    return true;
}

// Whoever ended the helper: what was under way is asked for again, and what is shown stays.
static bool look_at_helper(Session *session)
{
    if (!session->broker || !broker_renew(session->broker))
        return false;
    puts("the preview's helper process was ended from outside; another has taken its place");
    for (int kind = 0; kind < RUN_RENDER; kind++)
        for (int i = 0; i < PLAYERS; i++)
            session_drop(session, (RunKind)kind, i);
    session_ask_photons(session);
    if (session->rendering)
        session_render(session);
    return true;
}

bool session_poll(Session *session)
{
    bool news = look_at_helper(session);
    news |= poll_watch(session);
    news |= session_look_at_scene(session);
    news |= coach_poll(&session->coach);
    for (int i = 0; i < PLAYERS; i++)
        for (int kind = 0; kind < RUN_KINDS; kind++)
            news |= poll_run(session, (RunKind)kind, i);
    session_need(session);
    return news;
}

// What is waited for: photons or findings. NULL: nothing.
static Run *awaited(const Session *session)
{
    int last = session->asked.passes > 0 ? RUN_RENDER : RUN_RENDER - 1;
    for (int i = 0; i < PLAYERS; i++)
        for (int kind = RUN_PHOTONS; kind <= last; kind++)
            if (session->runs[kind][i] && !session->have[kind][i])
                return session->runs[kind][i];
    return NULL;
}

bool session_is_busy(const Session *session)
{
    return session->building || awaited(session);
}

void session_wait(Session *session, double seconds)
{
    Run *run = awaited(session);
    if (run)
        run_wait(run, seconds);
    else if (session->watch)
        watch_wait(session->watch, seconds);
}

ViewData *session_yours(const Session *session)
{
    return session->data[session->coming ? COMING : YOURS];
}
