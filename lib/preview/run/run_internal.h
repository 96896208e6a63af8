// Inside of a Broker and of a Run: the window's side, and its way to the helper.
#pragma once

#include "base/process.h"
#include "preview/record/rendered.h"
#include "preview/run/wire.h"

#include <sys/socket.h>

#ifndef MSG_NOSIGNAL
#define MSG_NOSIGNAL 0
#endif

struct Broker {
    const Scene *scene;
    int socket; // −1: the helper is gone
    pid_t pid;
    int helpers; // so many there have been
    double born; // when the last of them was forked
    int workers; // at most, per run
    Run *runs;   // that are not freed, newest first
    uint32_t last_run;
    char code_source[4096];
};

// What the workers' pipes travel in.
typedef union { // aligned as a header must be
    struct cmsghdr head;
    char bytes[CMSG_SPACE(MOST_WORKERS * sizeof(int))];
} WirePipes;

// The process that the broker forks: never returns.
void helper_run(const Scene *scene, int socket);

// Sends an order, with `pipes`, a file descriptor for each worker, to those that start.
bool broker_send(Broker *broker, const WireOrder *order, const int *pipes);
// Takes what the helper has told of workers that ended.
void broker_listen(Broker *broker);
// Ends a helper that does not answer.
void broker_lose(Broker *broker);

typedef struct {
    char *bytes;
    size_t size, capacity;
} Buffer;

// One worker, seen from the window's process.
typedef struct {
    int pipe;                 // −1: closed
    Buffer incoming;          // the message that is coming, with its head
    bool waiting;             // a whole picture whose turn has not come; nothing more is read meanwhile
    Buffer found[WIRE_FOUND]; // by the kind of message: photons, legs, samples
    bool done, ended;         // said that it was done; its process is gone
    Recording result;         // but for photons and legs
    int status;               // as waitpid gives it
    double fraction;
    pid_t pid;               // 0: not there yet
    double alive, processor; // when it was last heard of, and how much time of a processor it had used by then, s
    double asked;            // when it was asked where it is; 0: it was not
} Part;

struct Run {
    Broker *broker;
    Run *next;
    uint32_t number;
    int helper; // broker->helpers when it began
    RunRequest request;
    int part_count;
    Part parts[MOST_WORKERS];
    double patience, started;
    double polled; // when the window looked last
    RunStatus status;
    bool out_of_memory;

    // Why it failed
    bool failing;     // the place is looked up; the sentence will follow
    char words[1024]; // from WIRE_FAILED, or our own; "": none
    bool has_crash;
    WireCrash crash;
    bool stuck;       // it was ended by the watch over its signs of life
    bool still;       // … and has neither worked nor answered
    int end_status;   // of the part that failed
    Process looker;   // the program that looks up function and line
    char found[2048]; // what it printed
    size_t found_size;
    double look_until;

    Rendered rendered;
};

// Takes what has come from this part, for a moment at most. True: something was new, or may wait for the next time.
bool part_read(Run *run, Part *part, double until);
void part_free(Part *part);

// Fills in the notice.
void run_describe_oddities(Run *run);

void run_end_workers(Run *run);
// Whether a part has failed: then ends the others. The sentence may take a few more polls.
bool run_look_for_failure(Run *run, bool all_done);
void run_go_on_with_failure(Run *run);
