// `render` by passes: its flags, and the work.
#ifndef PHOTONLAB_CLI_RENDER_PASSES_H
#define PHOTONLAB_CLI_RENDER_PASSES_H

#include "cli/cli.h"
#include "cli/tev.h"
#include "render/passes/pass_file.h"

typedef struct {
    int passes;           // 0: no flag
    float seconds, alpha; // 0: no flag
    Choice radii;
    const char *part, *resume;
} PassFlags;

#define PASS_FLAGS(f)                                                                                                  \
    {"passes", FLAG_INT, &(f).passes, 1, MOST_PASSES}, {"seconds", FLAG_FLOAT, &(f).seconds, 1e-3, 1e9},               \
        {"alpha", FLAG_FLOAT, &(f).alpha, 1e-3, 1}, {"radii", FLAG_CHOICE, &(f).radii, 0, 0},                          \
        {"part", FLAG_TEXT, &(f).part, 0, 0},                                                                          \
    {                                                                                                                  \
        "resume", FLAG_TEXT, &(f).resume, 0, 0                                                                         \
    }

extern const char *const radii_names[]; // "pass", "pixel"

// Is the picture made by passes?
bool pass_flags_given(const PassFlags *flags);

// 0, or the exit code when they do not go together.
int pass_flags_check(const PassFlags *flags, const char *out);

// What a render by passes needs beside.
typedef struct {
    const char *scene, *out; // files
    int bits;                // of a PNG
    bool quiet;
    bool *sound; // becomes false when the picture holds what is no number
    Tev *tev;    // shows it; NULL: nobody does
} PassJob;

// Renders and writes. False with the reason, which may be that somebody stopped it.
bool render_by_passes(const PassJob *job, const PassFlags *flags, const Scene *scene, const RenderOptions *options,
                      RenderStats *stats, Error *error);

#endif
