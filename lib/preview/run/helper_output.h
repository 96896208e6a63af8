// What students' code prints goes through the helper process: the first lines of every run, and how many more there
// were. A printf in a step of the photon's life runs a million times, and a terminal full of it hides what was wanted.
#ifndef PHOTONLAB_PREVIEW_HELPER_OUTPUT_H
#define PHOTONLAB_PREVIEW_HELPER_OUTPUT_H

#include <stdbool.h>
#include <stddef.h>

#define OUTPUT_LINES 100 // of a run, that are passed on
#define OUTPUT_BYTES 16384

typedef struct {
    int read, write; // the ends of a pipe; −1: there is none, workers print for themselves
    long lines;
    size_t bytes;    // passed on since output_end
    long more_lines; // kept back
    unsigned long more_bytes;
    bool in_line; // the last byte that was passed on ended no line
} HelperOutput;

void output_open(HelperOutput *output);
// A worker's side: standard output and standard error go into the pipe from now on.
void output_join(const HelperOutput *output);
// Takes what has come, without waiting.
void output_pass_on(HelperOutput *output);
// Takes the rest, says how much was kept back, and counts anew.
void output_end(HelperOutput *output);

#endif
