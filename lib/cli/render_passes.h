// `render` by passes: its flags, and the work.
#ifndef PHOTONLAB_CLI_RENDER_PASSES_H
#define PHOTONLAB_CLI_RENDER_PASSES_H

#include "cli/cli.h"
#include "cli/tev.h"
#include "render/passes/pass_file.h"

// What the flags of `render` say, and what else a picture needs.
typedef struct {
    const char *scene, *out, *code, *steps, *tev; // scene, out: files
    int size[2];
    Choice integrator;
    int bits; // of a PNG
    bool quiet, json, spectral;
    int wavelengths;
    int passes;           // 0: no flag
    float seconds, alpha; // 0: no flag
    Choice radii;
    const char *part, *resume;
    RenderOptions options; // settings: 0 or −1: no flag, so the scene's own value counts
    Tev *viewer;           // shows it; NULL: nobody does
    bool sound;            // false: the picture holds what is no number
} RenderJob;

// Is the picture made by passes?
bool passes_wanted(const RenderJob *job);

// False, saying why, when the flags about passes do not go together.
bool pass_flags_check(const RenderJob *job, Error *error);

// Renders and writes. False with the reason, which may be that somebody stopped it.
bool render_by_passes(RenderJob *job, const Scene *scene, RenderStats *stats, Error *error);

#endif
