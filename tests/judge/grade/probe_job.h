// One run of the probe in the sandbox: what it may see, and what it must give back.
#ifndef PHOTONLAB_JUDGE_PROBE_JOB_H
#define PHOTONLAB_JUDGE_PROBE_JOB_H

#include "judge/grade/grade.h"

typedef struct {
    const char *directory; // for its cases and results
    char cases[4096];
    const char *words[16]; // of its command line, but for what every probe is told
    int word_count;
    char visible[MOST_VISIBLE][4096];
    int visible_count;
    double cpu_seconds;
} ProbeJob;

typedef struct {
    SandboxResult sandbox;
    float *storage; // owns the numbers; the caller frees it
    size_t whole;   // so many cases are complete
    bool forged;    // something stands in the results that no probe writes
    char message[1024];
} ProbeRun;

// A job that sees the program, its library and `directory`/`cases`; the directory's text must stay.
void probe_job_start(const GradeOptions *options, const char *directory, const char *cases, ProbeJob *job);
void probe_job_words(ProbeJob *job, const char *const *words, int count);
void probe_job_show(ProbeJob *job, const char *format, ...) PRINTF_LIKE(2, 3);

// Writes the lines, runs the probe. `id`: the step of `call` cases. STATUS_SKIP, with a message: it could not be run;
// STATUS_ERROR: it did not get through, or (with a message) it is forged.
Status probe_job_run(const GradeOptions *options, const ProbeJob *job, const char *id, char *const *lines, size_t count,
                     Numbers *numbers, ProbeRun *run);

#endif
