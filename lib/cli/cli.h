// The program's subcommands. Each takes its own arguments (arguments[0] is its name) and returns the exit code: 0
// done, 1 input or output error, 2 wrong usage.
#ifndef PHOTONLAB_CLI_CLI_H
#define PHOTONLAB_CLI_CLI_H

#include "base/command_line.h"
#include "photonlab.h"
#include "scene/limits.h"

#include <stdbool.h>

#define EXIT_INPUT 1

int command_render(int count, char **arguments);
int command_merge(int count, char **arguments);
int command_photons(int count, char **arguments);
int command_diff(int count, char **arguments);
int command_frame(int count, char **arguments);
int command_steps(int count, char **arguments);
int command_preview(int count, char **arguments);
int command_export(int count, char **arguments);

// Prints the error to standard error and returns EXIT_INPUT.
int report_error(const Error *error);

#define MOST_THREADS 1024

// A bar with the time that is left, on standard error, when that is a terminal; silent otherwise.
typedef struct {
    double started, drawn;
    char phase[32];
    bool wanted, shown;
} ProgressBar;
Progress progress_bar_start(ProgressBar *bar, bool quiet);
void progress_bar_end(ProgressBar *bar);

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

void print_ledger_json(const Ledger *ledger);

#endif
