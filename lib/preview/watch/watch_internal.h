// What the watch is made of.
#pragma once

#include "preview/watch/watch.h"
#include "preview/watch/job.h"
#include "steps/steps.h"

#include <stdint.h>

typedef struct {
    uint64_t fingerprint; // when it was last looked at; 0: it is not there
    uint64_t headers;     // of the student's own that it includes, all together
    bool dirty;           // was saved and waits to be built
    char error[300];      // of its last build; "": it went well
    double since;         // of the last sign that it was saved
} Source;

struct Watch {
    char source[2048], objects[2048];
    const char *command;
    Source files[STEP_COUNT];
    int inotify;             // −1: none
    int folders[STEP_COUNT]; // inotify's number for the folder of each step; −1: not there
    double looked;
    Job compiler;
    size_t building; // the step that it is at, or was
    char message[1024], warning[1024];
    char stray[512]; // a saved file that is named like no step; "": none
};

void watch_path(char path[4096], const char *folder, size_t step, const char *ending);
// Of the headers below the watched folder that the step's last build read, as the compiler has written them down beside
// the object. 0: none.
uint64_t watch_headers(const Watch *watch, size_t step);
bool watch_look_at(Watch *watch, size_t step); // true: its file is not as it was
void watch_mark(Watch *watch, size_t step);    // its file was saved, or may have been
WatchEvent watch_begin_build(Watch *watch, size_t step);
WatchEvent watch_end_build(Watch *watch); // without waiting

// By inotify; without it the first two do nothing, and times have to do.
void watch_start_listening(Watch *watch);
void watch_take_changes(Watch *watch);
