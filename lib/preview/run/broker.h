// Inside of a Broker: the window's side of it, which run.c works with, and the helper's side.
#ifndef PHOTONLAB_PREVIEW_BROKER_H
#define PHOTONLAB_PREVIEW_BROKER_H

#include "base/process.h"
#include "preview/run/wire.h"

// Who beats a heart.
typedef struct {
    uint32_t run; // 0: nobody
    int worker;
} HeartUse;

struct Broker {
    int socket; // −1: the helper is gone
    pid_t pid;
    int workers; // at most, per run
    WireHeart *hearts;
    HeartUse uses[MOST_HEARTS];
    Run *runs; // that are not freed, newest first
    uint32_t last_run;
    char code_source[4096];
    char incoming[sizeof(WireEnd)];
    size_t incoming_size;
};

// The helper's life: never returns.
void helper_run(const Scene *scene, int socket, WireHeart *hearts);

// Sends an order, with `workers` file descriptors for ORDER_START.
bool broker_send(Broker *broker, const WireOrder *order, const int *pipes);
// Takes what the helper has told, and passes it on by run_note_end.
void broker_listen(Broker *broker);
void run_note_end(Run *run, int worker, int status);
Run *run_find(Broker *broker, uint32_t number);

// The sentence for a worker that failed; see failure.c.
typedef struct {
    bool has_crash;
    WireCrash crash;
    bool stuck; // it was ended by the watch over its heart
    double patience;
    int status; // as waitpid gives it
    RunKind kind;
    const char *words; // from WIRE_FAILED; NULL: none
    const char *code_source;
} Failure;

// Starts to look for function and line, by a program of its own. False when there is nothing to look for.
bool failure_look_up(const Failure *failure, Process *looker);
// `found`: what that program printed, "" without it.
void failure_describe(const Failure *failure, const char *found, char *text, size_t size);

#endif
