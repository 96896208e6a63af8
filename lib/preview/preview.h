// The live preview: a window on the photons of the student's code, and the same picture without a display.
#pragma once

#include "preview/draw/context/context.h"
#include "preview/run/run.h"
#include "preview/view/view.h"

typedef struct {
    const char *scene_path;
    const char *code;     // folder of the student's objects; NULL: the reference plays everything
    const char *source;   // folder of the student's .c files, watched; NULL: nothing is
    const char *build;    // shell command that makes an object of one file; see watch.h
    int stage;            // whose steps come first; 0: any
    int stages;           // of the course, from the first; 0: all
    const char *judge;    // shell command that judges a step; see coach.h. NULL: nobody does
    const char *report;   // what the key `o` opens; NULL: nothing
    const char *snapshot; // the picture to write
    bool every_save;      // the same again after each, until the program is ended
    int width, height;    // pixels
    long photons;
    uint64_t seed;
    int depth;
    long recorded; // paths whose legs are kept
    bool play_is_given;
    StepChoice play;
    bool spectral;       // photons of single wavelengths
    int integrator;      // of pictures that are rendered: an Integrator; −1: as the scene says
    RadiiRule radii;     // of their passes
    int render;          // the picture is shown, and not photons: in a snapshot after so many passes. 0: photons
    float orbit_seconds; // the window turns by itself for so long, and tells how fast; 0: it does not
    ContextKind context; // a snapshot is drawn in
    bool in_window;      // … in a hidden one: --context window
    View view;
    const char *given[2]; // files of photons to show in a snapshot, with view.split the second's, too; NULL: a run's
} PreviewOptions;

// Opens the window and stays until it is closed. *no_window: the Error says why there is no window here.
bool preview_window(const Scene *scene, const PreviewOptions *options, Broker *broker, bool *no_window, Error *error);

// A picture into options->snapshot, by nobody's display. A fault in the student's code is the error, or, with
// options->every_save, told in the picture and on standard output.
bool preview_snapshot(const Scene *scene, const PreviewOptions *options, Broker *broker, Error *error);
