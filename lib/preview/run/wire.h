// What goes between the window's process, the helper and the workers. All three are one program: structs as they are.
#ifndef PHOTONLAB_PREVIEW_WIRE_H
#define PHOTONLAB_PREVIEW_WIRE_H

#include "preview/run/run.h"

#include <sys/types.h>

#define MOST_WORKERS 8
#define MOST_HEARTS  128 // workers of all runs together

// Memory that all share: a sign of life for each worker. Nothing in it is trusted, as students' code can write there.
typedef struct {
    volatile uint64_t beats;
    volatile double fraction; // 0…1 of the worker's part
    volatile long pid;
    char apart[40]; // a line of the cache each
} WireHeart;

// ---- window to helper, by a socket; with ORDER_START come the write ends of the workers' pipes ----

typedef enum {
    ORDER_START,
    ORDER_WHERE, // ask a worker where it is; it tells, and ends
    ORDER_END    // kill the run's workers
} OrderKind;

typedef struct {
    OrderKind kind;
    uint32_t run;
    int worker;  // ORDER_WHERE
    int workers; // ORDER_START, and each one's heart
    int hearts[MOST_WORKERS];
    RunRequest request;
    bool has_code;
    char code[4096]; // in place of request.code
} WireOrder;

// ---- helper to window: a worker is gone ----

typedef struct {
    uint32_t run;
    int worker, status; // as waitpid gives it
} WireEnd;

// ---- worker to window, by its pipe: heads, each with this many bytes behind it ----

typedef enum {
    WIRE_PHOTONS, // RecordedPhoton…
    WIRE_LEGS,    // PathLeg…
    WIRE_SAMPLES, // LobeSample…
    WIRE_PICTURE, // WirePicture, and its pixels
    WIRE_BEGUN,   // WireDone, of which states and play are known; the first one
    WIRE_DONE,    // WireDone; the last one
    WIRE_FAILED,  // why it could not begin, in words
    WIRE_CRASH    // WireCrash; a later one knows more than an earlier
} WireKind;
#define WIRE_FOUND (WIRE_SAMPLES + 1) // kinds before that are kept, message after message

typedef struct {
    uint32_t kind, bytes;
} WireHead;
#define WIRE_MOST_BYTES (1u << 30)

typedef struct {
    int width, height;
    bool quick; // a small one, to begin with
} WirePicture;

typedef struct {
    Ledger ledger;
    UnsoundPaths unsound;
    long emitted, redraw_caps;
    uint64_t segments;
    int bounces;
    StepState states[STEP_COUNT];
    StepChoice play;
} WireDone;

typedef struct {
    int signal;     // SIGUSR1: it was asked where it is; 0: exit() was called
    bool stack_far; // see Crash
    bool calls_itself;
    bool refused;                // the last that failed was to get memory
    unsigned long long grown_kb; // memory since the work began
    unsigned long long address;
    // The innermost place in the student's code; object "" when it was elsewhere.
    unsigned long long offset;
    char object[1024], symbol[128];
} WireCrash;

#define WORKER_MEMORY_GB 1

#endif
