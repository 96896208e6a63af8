// Grading: from a student's source files to a verdict on every step.
#ifndef PHOTONLAB_JUDGE_GRADE_H
#define PHOTONLAB_JUDGE_GRADE_H

#include "judge/checks/check.h"
#include "judge/sandbox/sandbox.h"

typedef enum { STATUS_PASS, STATUS_FAIL, STATUS_ERROR, STATUS_TODO, STATUS_SKIP } Status;
extern const char *const status_names[]; // "pass", …

#define MOST_CHECKS 12

typedef struct {
    const Check *check;
    Status status;
    double threshold; // for its p
    Finding finding;
} CheckResult;

typedef struct {
    const StepInfo *step;
    Status status;
    char message[1024]; // one sentence: expected and found, or what went wrong
    char where[256];    // "sample_lobe, line 12", empty when unknown
    char mistake[64];   // name of the likely mistake, empty when none is
    char looks_like[300];
    char output[16384]; // the compiler's lines, and what the code printed
    size_t compiled;    // bytes of the compiler's part
    CheckResult checks[MOST_CHECKS];
    int check_count;
    const char *failing_cases; // "calls.txt" or "scenes.txt" in the step's directory, and the number of the case there:
    long failing_case;         // what `make debug` runs again. NULL and −1: none in particular
    double points, points_max;
    double seconds;
    bool hidden;
    bool playable; // it is compiled, and nothing is wrong with its object
    char due[16];  // "2026-12-01" or empty
} StepResult;

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
    double cpu_seconds;        // a step's cases may take; wall clock: six times as long
    double speed;              // this machine's time for a fixed task ÷ the usual; time limits grow with it
    bool compile_only;         // not one check: for measuring the scatters
    bool first_round_only;     // no confirmation: for measuring the level
} GradeOptions;

// Grades one step. Never fails as a function: what goes wrong is the step's status.
void grade_step(const GradeOptions *options, const StepInfo *step, StepResult *result);
void step_result_free(StepResult *result);

const StepChecks *checks_of(const char *id);

// Compiles a step's source to work/<step>/step.so. STATUS_PASS when it is ready to run; otherwise status, message and
// output of the result are filled in.
Status compile_step(const GradeOptions *options, const StepInfo *step, StepResult *result);

// Runs the cases in the sandbox. `numbers` gets one entry a case (those never reached: NULL); *storage owns them.
// STATUS_PASS when all went through.
Status run_probe(const GradeOptions *options, const StepInfo *step, bool scene, char *const *lines, size_t count,
                 Numbers *numbers, float **storage, long *crashed_case, StepResult *result);

// Who likely made which mistake: compares features with tests/mistakes/features.txt.
void diagnose(const GradeOptions *options, StepResult *result);

// <work>/<step id>, made if it is not there.
void step_directory(const GradeOptions *options, const StepInfo *step, char *path, size_t size);

#endif
