// What the preview is busy with: the runs whose results will be shown, the watch, and the words about both. Knows
// nothing of windows; the window and the snapshots drive it alike.
#pragma once

#include "preview/preview.h"
#include "preview/watch/coach.h"
#include "preview/watch/watch.h"

// Whose code a run plays; and whose data can be shown. COMING: the student's photons that are there already, of a run
// that is not done. Not yet YOURS, since it may still crash.
enum { YOURS, REFERENCE, PLAYERS, COMING = PLAYERS, DATA_COUNT };
#define RUN_KINDS (RUN_RENDER + 1)

// What decides a picture, without gaps between: it is compared byte by byte.
typedef struct {
    Orbit orbit;
    int width, height, split;
} Seen;

typedef struct {
    const PreviewOptions *options;
    const View *view; // what is looked at, and so what is needed
    Canvas *canvas;
    Broker *broker;
    Watch *watch; // NULL: nothing is watched
    Coach coach;
    Run *runs[RUN_KINDS][PLAYERS]; // under way; a picture's stays when it has all of its passes
    bool have[RUN_KINDS][PLAYERS]; // what the data hold is of the present settings
    ViewData *data[DATA_COUNT];
    double lobe[MOST_SETTINGS]; // of the view, that its samples were asked with

    RunRequest asked;          // what is the same for all views and both players
    bool rendering;            // pictures are shown, and no photons
    Seen seen;                 // what they were asked of
    double render_started;     // clock_seconds()
    Image kept[PLAYERS];       // the picture before, until a new one is there
    double asked_at;           // clock_seconds() of the save or key that the coming photons answer
    const char *asked_by;      // "start", "key" or "save"
    bool after_save, answered; // … and its photons, or the first of them, are there
    bool coming;               // data[COMING] is what to show
    double next_look;          // clock_seconds(), at photons on their way
    bool building;
    bool timed; // words may tell seconds; not in snapshots, which are the same every time

    const Scene *scene;
    const char *scene_path;
    int stage;              // that the scene is of; 0: of none
    Scene *own_scene;       // the present one, where it is not that of the start,
    Broker *own_broker;     // and its
    double looked_at_scene; // clock_seconds()
    uint64_t scene_seen;    // fingerprint of its files; 0: not known

    char fault[600];        // of the last build or run of the student's code; "": none
    char build[300];        // the last build, in words
    char warning[300];      // what the compiler warned of in it; "": nothing
    char scene_fault[1000]; // why its file cannot be read; "": it can
    char notice[960];       // what right steps never do
    bool behind;            // what is shown is of an earlier save than the last
} Session;

// Asks for the first photons at once, unless options->given are to be shown.
bool session_start(Session *session, const Scene *scene, const PreviewOptions *options, const View *view,
                   Broker *broker, Canvas *canvas, Error *error);
void session_end(Session *session);

// Asks for new photons from the student's code, and from the reference if it is shown.
void session_ask_photons(Session *session);
// Asks one player for one kind; what was asked before is dropped.
void session_ask(Session *session, RunKind kind, int player);
// Asks for whatever the view needs and is not there yet.
void session_need(Session *session);
// What there is of one kind is out of date.
void session_drop(Session *session, RunKind kind, int player);
// Ends a run, if there is one.
void session_stop(Run **run);

// Takes what has come. True: something to see has changed. Prints what a student in front of a terminal wants to know:
// builds, faults, and how soon after a save its photons were there.
bool session_poll(Session *session);
// Something has been asked for that is not there yet.
bool session_is_busy(const Session *session);
// Sleeps until something comes or the time is up.
void session_wait(Session *session, double seconds);

// What the view shows, as large as the canvas; where it is split, half of it, and the reference's beside.
void session_render(Session *session);
void session_stop_render(Session *session);
void session_choose_way(Session *session); // as flags say, or else the scene and its stage
// A scene's file that was written anew, or one of its meshes, is loaded anew. True: something to see.
bool session_look_at_scene(Session *session);
// Prints and keeps what is not kept yet: the same mistake is told once. True: it is new.
bool session_tell(char *kept, size_t size, const char *text);
bool session_is_faulty(const Session *session); // something is said in the banner
// Another way to make a picture.
void session_next_way(Session *session);

// The student's data as they are to be shown now.
ViewData *session_yours(const Session *session);

// It is the present step now: shows the scene of its stage. NULL: there is none.
void session_show_step(Session *session, const StepInfo *step);

// Draws this view, of both if it is split, with the words that the session has for it. `help`: the list of keys, or NULL.
void session_draw(const Session *session, const View *view, const char *help);

// Writes what the canvas shows; the old file stays when that fails.
bool snapshot_write(Canvas *canvas, const char *path, Error *error);
// The flags that make the present picture again, to be typed.
void snapshot_command(const Session *session, char *text, size_t size);
