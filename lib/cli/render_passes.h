// `render` by passes: its flags, and the work.
#ifndef PHOTONLAB_CLI_RENDER_PASSES_H
#define PHOTONLAB_CLI_RENDER_PASSES_H

#include "cli/cli.h"
#include "cli/tev.h"
#include "render/passes/pass_file.h"

// What the flags of `render` say.
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
    RenderSettings settings; // 0 or −1: no flag, so the scene's own value counts
    RenderOptions options;
} RenderFlags;

extern const char *const radii_names[]; // "pass", "pixel"

// Is the picture made by passes?
bool passes_wanted(const RenderFlags *flags);

// False, saying why, when the flags about passes do not go together.
bool pass_flags_check(const RenderFlags *flags, Error *error);

// Renders and writes; tev, unless it is NULL, shows it. *sound becomes false when the picture holds what is no number. False with
// the reason, which may be that somebody stopped it.
bool render_by_passes(const RenderFlags *flags, const Scene *scene, Tev *tev, bool *sound, RenderStats *stats,
                      Error *error);

#endif
