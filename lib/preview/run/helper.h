// The helper process, and what passes through it.
#ifndef PHOTONLAB_PREVIEW_HELPER_H
#define PHOTONLAB_PREVIEW_HELPER_H

#include "preview/run/wire.h"

#include <sys/socket.h>

#ifndef MSG_NOSIGNAL
#define MSG_NOSIGNAL 0
#endif

// What the pipes travel in.
typedef union { // aligned as a header must be
    struct cmsghdr head;
    char bytes[CMSG_SPACE(MOST_WORKERS * sizeof(int))];
} WirePipes;

// The helper's life: never returns.
void helper_run(const Scene *scene, int socket);

// What students' code prints goes through the helper process: the first lines of every run, and how many more there
// were. A printf in a step of the photon's life runs a million times, and a terminal full of it hides what was wanted.
#define OUTPUT_LINES 100 // of a run, that are passed on
#define OUTPUT_BYTES 16384

typedef struct {
    int ends[2]; // of a pipe
    long lines;
    size_t bytes;    // passed on since output_end
    long more_lines; // kept back
    unsigned long more_bytes;
    bool in_line; // the last byte that was passed on ended no line
} HelperOutput;

// A worker's side: standard output and standard error go into the pipe from now on.
void output_join(const HelperOutput *output);
// Takes what has come, without waiting.
void output_pass_on(HelperOutput *output);
// Takes the rest, says how much was kept back, and counts anew.
void output_end(HelperOutput *output);

#endif
