// `make preview WEB=1`: a student's steps in a tab. tab.c builds what is saved and knows how the steps are; http.c gives it to the
// browser, gate.c decides to whom; main.c goes round.
#pragma once

#include "base/process.h"
#include "preview/record/fault.h"
#include "preview/watch/coach.h"
#include "preview/watch/watch.h"

#include <microhttpd.h>

typedef struct {
    const char *source, *objects; // folders: the student's .c files, and what they become
    const char *build;            // shell command, see watch.h
    const char *link;             // … sh -c LINK sh MODULE.wasm OBJECT…
    const char *judge;            // … see coach.h; NULL: nobody judges
    const char *page;             // folder of tab.html, tab.js and photonlab.wasm
    const char *scene;            // to begin with: a name in the page
    const char *steps;            // which play where several do the same work; NULL: what the student has
    int stage;                    // whose steps come first; 0: any
    int stages;                   // of the course, from the first; 0: all
    int port;                     // 0: any that is free
} TabOptions;

// ---- tab.c, failure.c ----

typedef struct {
    const TabOptions *options;
    Watch *watch;
    Coach coach;
    StepState states[STEP_COUNT];
    int stage;
    char scene[256];
    long number; // of the present state; counts up

    bool link_wanted;
    Process linker, looker;
    char said[16384], looked[8192]; // what they printed
    size_t said_size, looked_size;
    char module[4096]; // the file
    char *bytes;       // of the module that is shown; NULL: none yet
    size_t size;
    int module_number;
    char students[STEP_COUNT * 8]; // the ids of the steps in it

    Fault fault;            // that is looked up
    double look_until;      // clock_seconds()
    char failure[600];      // of the last run; "": none
    char link_failure[600]; // of the last link
    char build[1100], warning[1100];
    bool building;
} Tab;

bool tab_start(Tab *tab, const TabOptions *options, Error *error);
void tab_stop(Tab *tab);
bool tab_poll(Tab *tab); // never waits; true: something is new
bool tab_is_busy(const Tab *tab);
void tab_next_step(Tab *tab);
// What the page tells of a run that ended: "MODULE WHY RUN MEGABYTES OFFSET…". False: that is nothing it could tell.
bool tab_take_failure(Tab *tab, const char *text);
bool tab_poll_failure(Tab *tab); // true: its place is known

// ---- state.c ----

// All that the page shows, as JSON; to be freed. NULL: memory is short.
char *tab_state(const Tab *tab);

// ---- gate.c ----

typedef struct {
    char token[33];
    int port;
    char forwarded[300]; // the host that GitHub Codespaces forwards the port as; "": this is none of them
} Gate;

bool gate_make(Gate *gate, int port); // false: there are no random numbers for a token
// Why this request is none of the page's own; NULL: it is. *path: what it asks for, behind the token.
const char *gate_refuses(const Gate *gate, struct MHD_Connection *connection, const char *method, const char *url,
                         const char **path);

// ---- http.c ----

typedef struct Server Server;
Server *server_start(Tab *tab, const TabOptions *options, Error *error);
void server_stop(Server *server);
// Tells how to reach it.
void server_greet(const Server *server);
// Waits for so long, or until something comes, and answers it. `news`: whoever waits for another state gets it.
void server_run(Server *server, int milliseconds, bool news);
