// A submission: the files that a student hands in, and the way of each to a shared object that the probe can load.
#pragma once

#include "judge/report/status.h"
#include "judge/sandbox/sandbox.h"
#include "steps/steps.h"

// How a submission is graded.
typedef struct {
    const char *code;       // directory laid out like exercises/
    const char *root;       // of the checkout: lib/, scenes/, tests/
    const char *build;      // where photonlab, its library and solutions/ lie
    const char *work;       // directory for objects and cases, one folder per step
    const char *compiler;   // "gcc"
    const char *flags;      // parted by blanks
    const char *link_flags; // for a step's shared object
    const char *salt;       // another salt, other random numbers
    SandboxKind sandbox;
    char *hidden[MOST_HIDDEN]; // absolute paths that a student's code must not read, NULL last
    bool memory_limit;         // false under AddressSanitizer
    double cpu_seconds;        // a step's cases may take; wall clock: three times as long
    double speed;              // this machine's time for a fixed task ÷ the usual; time limits grow with it
    bool compile_only;         // not one check: for measuring the scatters
    bool no_pictures;          // for measuring features, which pictures have none of in the table
    bool first_round_only;     // no confirmation: for measuring the level
} GradeOptions;

// What a student is told of a step, but for what the checks found.
typedef struct {
    char message[1024]; // one sentence: expected and found, or what went wrong
    char where[256];    // "sample_lobe, line 12", empty when unknown
    char output[16384]; // the compiler's lines, and what the code printed
    size_t compiled;    // bytes of the compiler's part
} StepWords;

// Sets the message and returns the status, as in `return words_say(words, STATUS_ERROR, …)`.
Status words_say(StepWords *words, Status status, const char *format, ...) PRINTF_LIKE(3, 4);

// False, with a reason, when there is no such folder, or something in it is neither file nor folder. Files that look like steps but lie or are called otherwise than
// one are named on standard error: they would count as not started without a word.
bool submission_look_over(const char *code, Error *error);

// <work>/<step id>, made if it is not there.
void step_directory(const GradeOptions *options, const StepInfo *step, char *path, size_t size);

// Compiles a step's source to work/<step>/step.so. STATUS_PASS when it is ready to run; otherwise the words tell why not.
Status compile_step(const GradeOptions *options, const StepInfo *step, StepWords *words);

// ---- parts of compile_step

// STATUS_TODO: it still calls todo(). STATUS_ERROR: it names what steps must not use (rand, system, …), keeps variables
// between calls, or lacks its function.
Status object_check(const GradeOptions *options, const StepInfo *step, const char *source, const char *object,
                    StepWords *words);

// A step that still calls todo() although its file is no longer the empty one: says so.
void submission_note_todo(const GradeOptions *options, const StepInfo *step, const char *source, StepWords *words);
