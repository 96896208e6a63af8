// What the preview is busy with: the runs whose results will be shown, the watch, and the words about both. Knows
// nothing of windows; the window and the snapshots drive it alike.
#ifndef PHOTONLAB_PREVIEW_SESSION_H
#define PHOTONLAB_PREVIEW_SESSION_H

#include "preview/preview.h"
#include "preview/watch/watch.h"

// COMING: the student's photons that are there already, of a run that is not done. Not yet YOURS, since it may still crash.
enum { YOURS, REFERENCE, RUN_SIDES, COMING = RUN_SIDES, SIDES };

typedef struct {
    const Scene *scene;
    const PreviewOptions *options;
    Broker *broker;
    Watch *watch; // NULL: nothing is watched
    Run *tracing[RUN_SIDES], *lobe[RUN_SIDES], *render;
    Side *sides[SIDES];

    long photons;
    uint64_t seed;
    bool have_reference, have_lobe[RUN_SIDES]; // what the sides hold is of the present settings
    double asked_at;                           // clock_seconds() of the save or key that the coming photons answer
    const char *asked_by;                      // "start", "key" or "save"
    bool after_save, answered;                 // … and its photons, or the first of them, are there
    bool coming;                               // sides[COMING] is what to show
    double next_look;                          // clock_seconds(), at photons on their way
    int render_width, render_height;           // of the picture that is rendered
    bool building;
    bool timed; // words may tell seconds; not in snapshots, which are the same every time

    double looked_at_scene;  // clock_seconds()
    long long scene_changed; // when its file was written, s; 0: not known
    bool scene_is_old;       // it has been written since

    char fault[600];   // of the last build or run of the student's code; "": none
    char build[300];   // the last build, in words
    char warning[300]; // what the compiler warned of in it; "": nothing
    char notice[960];  // what right steps never do
} Session;

bool session_start(Session *session, const Scene *scene, const PreviewOptions *options, Broker *broker, Canvas *canvas,
                   Error *error);
void session_end(Session *session);

// Asks for new photons from the student's code, and from the reference if it is shown.
void session_ask_photons(Session *session, const View *view);
// Asks for whatever this view needs and is not there yet.
void session_need(Session *session, const View *view);
// Asks for one side's photons; what was asked before is dropped. Ends a run, if there is one.
void session_ask_side(Session *session, int side);
void session_stop(Run **run);
// The exponent, the angle or the kind of the lobe has changed.
void session_lobe_changed(Session *session, const View *view);

// Takes what has come. True: something to see has changed. Prints what a student in front of a terminal wants to know:
// builds, faults, and how soon after a save its photons were there.
bool session_poll(Session *session, const View *view);
// Something has been asked for that is not there yet.
bool session_is_busy(const Session *session);
// Sleeps until something comes or the time is up.
void session_wait(Session *session, double seconds);

void session_render(Session *session, const View *view, int width, int height);
void session_stop_render(Session *session);

// The student's side as it is to be shown now.
Side *session_yours(const Session *session);

// What is wrong, a line each: the fault, what the compiler warned of, what right steps never do. "": nothing.
void session_banner(const Session *session, char *text, size_t size);
// The line at the bottom.
void session_status(const Session *session, char *text, size_t size);

#endif
