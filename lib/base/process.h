// A program that runs in the background, what it prints coming down a pipe.
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

typedef struct {
    pid_t pid;  // 0: nothing runs
    int output; // never waits when read; −1: closed
} Process;

// However often a signal cuts it. False: nobody reads.
bool write_all(int file, const void *bytes, size_t size);

// A pipe that programs started meanwhile do not inherit, and whose reader never waits. False: errno.
bool pipe_open(int ends[2]);

// Starts arguments[0], looked for as a shell does, in a process group of its own; it, and whatever is started later, with
// LC_ALL=C, since what it says is looked through for English words. What it prints is read from `output`: all, or standard output or standard error alone.
typedef enum { PRINTS_OUTPUT = 2, PRINTS_ERRORS = 4, PRINTS_ALL = 6 } ProcessPrints; // bits by the streams' numbers
bool process_start(Process *process, const char *const *arguments, ProcessPrints prints); // false: errno
// Takes what has come, up to size − 1 bytes in all; what is too much is thrown away. `output` is closed at its end.
void process_read(Process *process, char *text, size_t size, size_t *used);
// Without waiting: has it ended? Then *status is as waitpid gives it, and the process is none any more but for its output.
bool process_has_ended(Process *process, int *status);
// Kills it and all that it started, and closes its output.
void process_kill(Process *process);
// Asks it to end and to end what it started; what has not ended after 0.3 s is killed. A shell in between has to `exec`, so that nobody
// waits for the dead of its group.
void process_end(Process *process);
