// A shell command that runs in the background, and what it has printed.
#pragma once

#include "base/process.h"

typedef struct {
    Process process;
    double started;
    char text[16384]; // the first part of what it printed
    size_t size;
} Job;

// Runs `sh -c command sh first second` with LC_ALL=C, in a process group of its own. `second` may be NULL. False: errno.
bool job_start(Job *job, const char *command, const char *first, const char *second);
// Without waiting: has it ended? Then *status is as waitpid gives it; −1: it was ended, after `longest` seconds.
bool job_poll(Job *job, double longest, int *status);
