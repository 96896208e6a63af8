// What goes between the window's process, the helper and the workers. All three are one program: structs as they are.
#pragma once

#include "base/crash_report.h"
#include "preview/run/run.h"

#define MOST_WORKERS 8

// ---- window to helper, by a socket; with the order to start come the write ends of the workers' pipes ----

typedef struct {
    uint32_t run;
    int signal; // 0: start workers; SIGKILL for all of the run; SIGUSR1 asks `worker` where it is: it tells, and ends
    int worker, workers;
    RunRequest request;
    char code[4096]; // in place of request.code; "": none
} WireOrder;

// ---- helper to window: a worker is gone ----

typedef struct {
    uint32_t run;
    int worker, status; // as waitpid gives it
} WireEnd;

// ---- worker to window, by its pipe: heads, each with this many bytes behind it ----

typedef enum {
    WIRE_PHOTONS,  // RecordedPhoton…
    WIRE_LEGS,     // PathLeg…
    WIRE_FINDINGS, // items of run_take_findings
    WIRE_ALIVE,    // nothing but the head
    WIRE_PICTURE,  // WirePicture, and its pixels
    WIRE_BEGUN,    // Recording, of which states and play are known; the first one
    WIRE_DONE,     // Recording, but for what went before; the last one
    WIRE_FAILED,   // why it could not begin, in words
    WIRE_CRASH     // WireCrash; a later one knows more than an earlier
} WireKind;
#define WIRE_FOUND (WIRE_FINDINGS + 1) // kinds before that are kept, message after message

// Each is a sign of life as well.
typedef struct {
    uint32_t kind, bytes;
    double fraction; // 0…1 of the worker's part
    int64_t pid;     // the worker's
} WireHead;
#define WIRE_MOST_BYTES (1u << 30)

typedef struct {
    int width, height;
    bool quick;  // a small one, to begin with
    int mean_of; // so many passes; 0: it is one pass
} WirePicture;

typedef struct {
    Crash at;                    // signal SIGUSR1: it was asked where it is; 0: exit() was called
    unsigned long long grown_kb; // memory since the work began
    InnerPlace inner;            // in the student's code
} WireCrash;
