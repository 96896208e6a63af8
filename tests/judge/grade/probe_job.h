// One run of the probe in the sandbox: what it may see, and what it must give back.
#ifndef PHOTONLAB_JUDGE_PROBE_JOB_H
#define PHOTONLAB_JUDGE_PROBE_JOB_H

#include "judge/grade/grade.h"

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

#endif
