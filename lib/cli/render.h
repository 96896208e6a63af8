// The command `render`: its flags, the work by passes, and a live picture in the viewer tev.
#pragma once

#include "cli/cli.h"
#include "render/passes/pass_file.h"

#define TEV_PORT "14158" // where tev listens, unless --host tells it otherwise

// Connects to "HOST" or "HOST:PORT" and opens a black picture there under this name; both texts are to stay till the end. False,
// with the error, when nobody answers.
bool tev_open(const char *address, const char *name, int width, int height, Error *error);

// Shows a rectangle of the picture, or all of it. A viewer that has gone is told of by tev_close, and holds up nothing; one that takes
// nothing for ten seconds counts as gone. tev_show is one of RenderOptions.tiles.
void tev_show(void *user, const Image *image, int x, int y, int width, int height);
void tev_show_all(const Image *image);

// False, with the error, when the viewer went before the end. The picture stays there.
bool tev_close(Error *error);

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
    RenderOptions options; // settings: 0 or −1: no flag, until complete_settings puts the scene's own value there
    bool sound;            // false: the picture holds what is no number
} RenderJob;

// Is the picture made by passes?
bool passes_wanted(const RenderJob *job);

// False, saying why, when the flags about passes do not go together.
bool pass_flags_check(const RenderJob *job, Error *error);

// Renders and writes. False with the reason, which may be that somebody stopped it.
bool render_by_passes(RenderJob *job, const Scene *scene, RenderStats *stats, Error *error);
