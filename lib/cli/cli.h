// The program's subcommands, and what they share.
#pragma once

#include "base/command_line.h"
#include "photonlab.h"
#include "scene/limits.h"

#include <stdbool.h>

#define EXIT_INPUT 1

typedef struct {
    const char *words;     // what `photonlab help` says of it
    CommandLine line;      // its command: "photonlab NAME"
    const char **files;    // where their names go
    bool (*prepare)(void); // before its arguments are read; may be NULL. False: it cannot be had, as is said by then
    int (*run)(void); // with what was read. The exit code: 0 done, EXIT_INPUT a file's error, EXIT_USAGE wrong usage
} Command;
extern const Command command_render, command_preview, command_merge, command_photons, command_diff, command_export,
    command_frame, command_steps;

// Prints the error to standard error and returns EXIT_INPUT.
int report_error(const Error *error);

#define MOST_THREADS 1024

// A bar with the time that is left, on standard error, when that is a terminal; silent otherwise. There is one.
Progress progress_bar_start(bool quiet);
void progress_bar_end(void);

// Before the work: which steps the student's code plays, and which are there but do not play.
void report_steps(StepChoice choice, bool path_tracer);

// Which steps play: those of --steps, or what the student's code has. --spectral, or the scene's key where there is no --steps,
// asks for single wavelengths.
void choose_steps(const char *code, const char *steps_text, bool spectral, const Scene *scene, StepChoice *play);

// After the work: what right steps never do. Lobes redrawn too often, directions of no length, flux from nowhere.
void report_oddities(const Ledger *ledger, long paths, const UnsoundPaths *unsound);

// Writes a picture by the file's ending. What is no number is marked, written, and an error all the same: *sound becomes false.
bool write_picture(Image *image, const char *path, int bits, bool *sound, Error *error);

// After a picture that could not be written: where a value that is no number may have come from.
void report_suspects(StepChoice choice);

// A command that plays students' code works in a process of its own: where that crashes or never ends, the other one says in
// which step and line. Splits the program in two, before there are threads or scenes. Returns in the one that works; the other
// waits, explains and ends with the same exit code, or EXIT_INPUT. `code`: the folder of the objects; NULL: nothing happens.
// `threads`: as for parallel_threads, how many will work. Where no process can be had, the work goes on unguarded.
void guard_begin(const char *code, int threads);

// A sign of life from the work: a part of it is done.
void guard_alive(void);

// The end of the line of JSON: what right steps never do, and the ledger.
void print_ledger_json(const Ledger *ledger, const UnsoundPaths *unsound);
