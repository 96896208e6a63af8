// How a run of students' code failed: a record, and its sentence for the student, whether it ran in a process or in a browser.
#pragma once

#include "base/crash_report.h"
#include "preview/record/recording.h"

#define WORKER_MEMORY_GB 1 // that students' code has

typedef enum {
    FAULT_SIGNAL, // a segmentation fault or the like; in a browser a trap
    FAULT_ABORT,
    FAULT_EXIT,
    FAULT_STACK,
    FAULT_MEMORY,
    FAULT_LOOP,
    FAULT_KINDS
} FaultKind;

typedef struct {
    FaultKind kind;
    SourcePlace place; // file "": in none of the student's steps
    int signal;        // FAULT_SIGNAL, and the address that was touched
    unsigned long long address;
    bool calls_itself; // FAULT_STACK
    double memory_gb;  // FAULT_MEMORY: that it had when it was stopped; 0: more was refused
    RunKind run;       // FAULT_LOOP: what it was to do,
    double patience;   // and was given for a part of it, s
} Fault;

// "1.3_scatter_diffuse.c:14: scatter_diffuse: segmentation fault …"
void fault_describe(const Fault *fault, char *text, size_t size);

void fault_describe_what(const Fault *fault, char *what, size_t size); // the same without the place

// A step calls a function that nobody has. `symbol`: its name, with anything behind; `folder`: of the student's files.
void fault_describe_missing(const char *folder, const StepInfo *step, const char *symbol, char *text, size_t size);

// A student saves, and nothing changes: another step does that work. False: theirs plays. `make`: how they call the preview.
bool fault_describe_unplayed(const Recording *recording, const StepInfo *step, const char *make, char *text,
                             size_t size);

// The name of a step's file: "1.3_scatter_diffuse.c" of "…/1.3_scatter_diffuse", with or without ".so".
void fault_source_name(const char *path, char *file, size_t size);
