// Watching a folder of exercises and building what is saved.
#pragma once

#include "base/error.h"
#include "steps/steps.h"

#include <stdint.h>

typedef struct Watch Watch;

typedef enum {
    WATCH_NOTHING,
    WATCH_BUILDING, // a save was seen, the compiler runs
    WATCH_BUILT,    // the objects are new: run again
    WATCH_FAILED    // watch_message tells why, the old objects stay; also for a file that is named like no step
} WatchEvent;

// Watches source/<stage>/*.c (laid out as exercises/), and the headers of their own that these include. For each file that
// is saved, or has no object that is newer, runs, with LC_ALL=C,
//     sh -c command sh SOURCE.c OBJECT.so
// where OBJECT.so is below `objects`; the command must write beside and rename. A step that was deleted loses its object.
// Directories are watched, not files (editors rename). Times are looked at as well, once a second, for changes that
// another machine makes; ten times a second where inotify is missing or PHOTONLAB_WATCH=times is set.
// `command` has to stay.
Watch *watch_start(const char *source, const char *objects, const char *command, Error *error);
void watch_stop(Watch *watch);

// Never waits. A save during a build starts the build again.
WatchEvent watch_poll(Watch *watch);
// Sleeps until something may have happened or the time is up.
void watch_wait(Watch *watch, double seconds);

// Of the last build: WATCH_BUILT "1.3_scatter_diffuse.c: built in 0.12 s"; WATCH_FAILED the compiler's first error line,
// "1.3_scatter_diffuse.c:12:5: error: expected ';' …"
const char *watch_message(const Watch *watch);
// The compiler's first warning in a build that succeeded, such as a forgotten return; "" if there was none.
const char *watch_warning(const Watch *watch);

// What tells one state of a file from the next, and of those in the sum. 0: an empty sum, and no such file.
uint64_t watch_fingerprint(uint64_t sum, const char *path);

// The step that was built last.
const StepInfo *watch_step(const Watch *watch);
// The compiler's first error line for the first step whose last build failed; "": there is none.
const char *watch_broken(const Watch *watch);
