// Grading: from a student's source files to a verdict on every step.
#pragma once

#include "judge/checks/check.h"
#include "judge/submission/submission.h"

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
    StepWords words;
    char mistake[64]; // name of the likely mistake, empty when none is
    char looks_like[300];
    char tile[100]; // its place in the notes' gallery, "m-1-1-…"; empty: it has none
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

// Grades one step. Never fails as a function: what goes wrong is the step's status.
void grade_step(const GradeOptions *options, const StepInfo *step, StepResult *result);
void step_result_free(StepResult *result);

// Runs and judges the checks of one kind (called alone or in scenes). STATUS_ERROR: the code did not get through.
Status run_checks(const GradeOptions *options, const StepChecks *checks, bool scene, int round, StepResult *result);

// Runs the cases in the sandbox. `numbers` gets one entry a case (those never reached: NULL); *storage owns them.
// STATUS_PASS when all went through.
Status run_probe(const GradeOptions *options, bool scene, const Plan *plan, Numbers *numbers, float **storage,
                 long *crashed_case, StepResult *result);

// Where the step printed and failed: keeps of what it printed what it prints in the case that failed, run again alone.
void show_printed(const GradeOptions *options, StepResult *result);

// ---- probe_job.c: one run of the probe in the sandbox, what it may see, and what it must give back

typedef struct {
    char directory[4000];                         // for its cases and results
    const char *cases;                            // the file's name there
    const char *id;                               // the step that it calls; NULL: those of `list` play in scenes
    const char *list;                             // "2.1,2.4"
    bool student[STEP_COUNT], hidden[STEP_COUNT]; // whose object is the student's, and which solutions it must not see
    double cpu_seconds;
} ProbeJob;

typedef struct {
    SandboxResult sandbox;
    float *storage; // owns the numbers; the caller frees it
    size_t whole;   // so many cases are complete
    bool forged;    // something stands in the results that no probe writes
    char message[1024];
} ProbeRun;

// Writes the lines, runs the probe. STATUS_SKIP, with a message: it could not be run; STATUS_ERROR: it did not get through, or
// (with a message) it is forged.
Status probe_job_run(const GradeOptions *options, const ProbeJob *job, char *const *lines, size_t count,
                     Numbers *numbers, ProbeRun *run);

// ---- crash.c, diagnosis.c

// Fills in message and where for a run that did not get through. `step` NULL: several ran, and the probe says in which of them it
// was.
void crash_describe(const GradeOptions *options, const SandboxResult *ran, const StepInfo *step, StepWords *words);

// Who likely made which mistake: compares features with tests/mistakes/features.txt.
void diagnose(const GradeOptions *options, StepResult *result);
