// Runs a program that is not trusted: the probe with a student's code in it, or the compiler on a student's source.
// May be called from several threads at once.
#pragma once

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>

typedef enum {
    SANDBOX_BUBBLEWRAP, // namespaces: sees only what it is shown
    SANDBOX_UID,        // as root without bubblewrap: a user of its own, seccomp, and Landlock where the kernel has it
    SANDBOX_LANDLOCK,   // neither: opens what it is shown by Landlock, seccomp
    SANDBOX_NONE        // limits only; no grading for credit
} SandboxKind;

// Picks the best there is on this machine (environment PHOTONLAB_SANDBOX=bubblewrap|uid|landlock|none asks for one of them). For
// SANDBOX_NONE, `reason` says why, in words for the person at the terminal; otherwise it is empty.
SandboxKind sandbox_open(char *reason, size_t size);
const char *sandbox_name(SandboxKind kind); // "bubblewrap", …

#define MOST_VISIBLE 48
#define MOST_HIDDEN  16
typedef struct {
    const char *const *arguments; // program first, NULL last
    // Absolute paths, NULL last, of files and directories: what it may read (what is not there is passed over); and what it must not,
    // but for what is visible in them: SANDBOX_UID refuses to run while others can read that.
    const char *visible[MOST_VISIBLE], *hidden[MOST_HIDDEN];
    const char *writable; // a directory that it may write to; NULL: none
    int result_fd;        // becomes its descriptor 3; −1: none
    bool compiler;        // may start processes and write files, as compilers do
    double cpu_seconds;
    double wall_seconds;     // that it may wait without any processor time; ten times as long in all
    long memory_mb, file_mb; // memory 0: no limit (AddressSanitizer)
} SandboxRun;

typedef struct {
    int exit_code;  // when it ended by itself; −1 otherwise
    int signal;     // that ended it, 0: none
    bool timed_out; // wall clock
    double cpu_seconds, wall_seconds;
    double cpu_limit, wall_limit; // as they were asked for
    long memory_mb;
    char text[32768];     // what it printed (both streams); of more its beginning and its end, and a line between …
    bool keeps_beginning; // … or, of a compiler, the beginning alone
    size_t left_out;      // bytes
} SandboxResult;

// False only when it could not be started at all.
bool sandbox_run(SandboxKind kind, const SandboxRun *run, SandboxResult *result, Error *error);

// The name of a system call that the sandbox stopped, to be freed; NULL: this kernel has none of that number.
char *sandbox_call_name(long long number);
