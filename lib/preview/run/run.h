// Running students' code without harm to the window: requests, and what comes back.
//
// Student code never runs in the window's process. broker_start forks a helper, which holds the scene; for each request
// the helper forks workers, which load the steps afresh, work, and send what they find down a pipe. A worker that
// crashes, hangs or eats memory is named and ended, and costs that request alone.
#pragma once

#include "image/image.h"
#include "preview/record/recording.h"
#include "scene/scene.h"

typedef struct Broker Broker;

// Call first thing, before steps_load, any window or GL context: it forks. The scene stays the caller's, and has to stay; the
// helper has a copy. `code_source`: the folder of the student's .c files, for messages ("exercises"); NULL: none.
Broker *broker_start(const Scene *scene, const char *code_source, Error *error);
void broker_stop(Broker *broker); // ends the helper and all workers; frees the runs
// Did the helper end, or was it ended, since the last call? Then another has taken its place, and what was asked for has to be
// asked again. False as well when none can be had, once a second and MOST_HELPERS times at most.
bool broker_renew(Broker *broker);
#define MOST_HELPERS 20
// From now on runs have at most so many workers; 0: one a core.
void broker_workers(Broker *broker, int most);

// By which radii passes look for photons: RADII_ALIKE, each pass is a picture by itself. Otherwise they are progressive photon
// mapping: by step 5.1 from pass to pass, and joined by 5.2, or for each pixel by 5.3 and 5.4.
typedef enum { RADII_ALIKE, RADII_BY_PASS, RADII_BY_PIXEL, RADII_RULES } RadiiRule;
extern const char *const radii_rules[RADII_RULES + 1]; // "alike", "pass", "pixel"; ends with NULL

typedef struct {
    RunKind kind;
    const char *code;   // folder of the student's objects; NULL: the reference plays everything
    bool play_is_given; // otherwise step_choice_for_student()
    StepChoice play;
    bool spectral; // photons of single wavelengths, whatever the choice; where none is given, by the scene's key, too
    uint64_t seed;
    // RUN_PHOTONS
    long photons;  // to emit
    int depth;     // surfaces a path may meet; 0: as the scene says
    long recorded; // paths whose legs are kept
    // RUN_LOBE: `samples` directions from scatter_glossy, or scatter_diffuse where `diffuse`, about the normal +z, for a
    // photon that flies in the xz plane towards the origin and whose mirror direction is `angle` degrees from the normal,
    // on the side of +x.
    float exponent, angle;
    long samples;
    bool diffuse;
    // RUN_RENDER: passes of one eye ray a pixel, with `photons` photons each and a seed of its own
    Integrator integrator;
    RadiiRule radii;
    int passes; // so many and no more; 0: until run_free
    Camera camera;
    int width, height;
} RunRequest;

typedef enum { RUN_GOING, RUN_DONE, RUN_FAILED } RunState;

typedef struct {
    RunState state;
    bool news;       // something came in this poll
    double fraction; // 0…1 of the work
    // RUN_FAILED: one line for the student, "1.3_scatter_diffuse.c:14: scatter_diffuse: segmentation fault …"
    char failure[512];
    char notice[640]; // RUN_DONE: oddities, as report_oddities words them, a line each; "" if none
} RunStatus;

typedef struct Run Run;

// Starts at once and returns; NULL when the helper is gone or pipes are short.
Run *run_start(Broker *broker, const RunRequest *request, Error *error);
// Takes what has come, without waiting. Ends a worker that gave no sign of life for `patience` seconds (2 by default,
// five times as much where pictures are made; up to three times as much where the worker did not get a processor).
RunStatus run_poll(Run *run);
// Sleeps until something comes or the time is up.
void run_wait(Run *run, double seconds);
void run_patience(Run *run, double seconds);
// Kills what still works. Results that were not taken go, too.
void run_free(Run *run);

// What a finished run found, taken over by the caller.
Recording run_take_recording(Run *run);
// A copy of what has come of a run that still goes on: photons and legs of the first paths of each worker, and so a fair
// sample. False: nothing has come yet, or memory is short. `emitted` says about how many paths that were; powers are
// those of the whole run, so the request's photons over `emitted` makes them as bright as they will be. The ledger is
// not known yet.
bool run_copy_partial(Run *run, Recording *recording);

// Of any other kind but RUN_RENDER.
Findings run_take_findings(Run *run);

// The mean of the passes that have come so far; owned by the run, and changed by later polls. NULL: none yet; 0 passes:
// a quick look, a pass of a sixteenth of the pixels blown up. The same seed and passes give the same bytes.
const Image *run_image(const Run *run, int *passes);
Image run_take_image(Run *run); // it is the caller's; the run has none any more
