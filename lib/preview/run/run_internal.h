// Inside of a Run.
#ifndef PHOTONLAB_PREVIEW_RUN_INTERNAL_H
#define PHOTONLAB_PREVIEW_RUN_INTERNAL_H

#include "preview/run/broker.h"

// A growing array of what one kind of message brings.
typedef struct {
    char *bytes;
    size_t size, capacity;
} Buffer;

// One worker, seen from the window's process.
typedef struct {
    int pipe; // −1: closed
    int heart;
    WireHead head;
    size_t head_size;         // bytes of the head that have come
    Buffer payload;           // of the message that is coming
    bool waiting;             // a whole picture whose turn has not come; nothing more is read meanwhile
    Buffer found[WIRE_FOUND]; // by the kind of message: photons, legs, samples
    bool done, ended;         // said that it was done; its process is gone
    WireDone result;
    int status;
    uint64_t beats;
    double alive, processor; // when it was last seen alive, and how much time of a processor it had used by then, s
    double asked;            // when it was asked where it is; 0: it was not
} Part;

struct Run {
    Broker *broker;
    Run *next;
    uint32_t number;
    RunRequest request;
    int part_count;
    Part parts[MOST_WORKERS];
    double patience, started, seconds;
    RunStatus status;
    bool out_of_memory;

    Failure failure; // while it is looked up, and after
    bool failing;
    char words[1024];
    Process looker; // the program that looks
    double look_until;
    char found[2048];
    size_t found_size;

    Image image;
    int passes;
};

// Takes what has come from this part, for a moment at most. True: something was new.
bool part_read(Run *run, Part *part, double until);
void part_free(Part *part);
bool buffer_add(Buffer *buffer, const void *bytes, size_t size);

// A picture that has come whole. False: its turn has not come.
bool run_take_picture(Run *run, Part *part);

// Fills in the notice.
void run_describe_oddities(Run *run);

void run_end_workers(Run *run);
// Looks whether a part has failed, and then ends the others. The sentence may take a few more polls.
void run_look_for_failure(Run *run);
void run_go_on_with_failure(Run *run);

#endif
