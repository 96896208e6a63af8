// The eye pass: from a scene and its photons to an image.
#pragma once

#include "image/image.h"
#include "photons/irradiance.h"
#include "photons/pass/photon_pass.h"
#include "steps/steps.h"

// A picture that is one pass of many (render/passes), with photons of its own.
typedef struct {
    float radius;          // m: all photons nearer than this count, caustic ones nearer than half of it; k is not asked
    uint64_t seed;         // the passes' eye rays are one sequence, …
    uint32_t first_sample; // … which goes on here
    PointStatistics
        *points; // PHOTONS: one a pixel, row by row, with a radius of its own; photons go in here, by step 5.3
    float alpha; // for it, and not into the picture. NULL: `radius` counts
} RenderPass;

typedef struct {
    Integrator integrator;
    RenderSettings settings;
    uint64_t seed;
    int threads;            // 0: all cores
    StepChoice play;        // 2.3 or 2.4; 1.5, 3.4 or, for single wavelengths, 6.4
    bool hero;              // with wavelengths: a photon has three, until it meets dispersing glass
    int glass_sides;        // 2; 1: eye rays bend on the way into glass only, the source text's looking glass
    float reuse;            // PHOTONS: estimates from the maps are shared within this part of their radius; 0: none is
    const RenderPass *pass; // NULL: a picture by itself
    Progress progress;
    struct { // is given each rectangle of pixels as soon as it is done, one after the other. NULL: is not called
        void (*take)(void *user, const Image *image, int x, int y, int width, int height);
        void *user;
    } tiles;
    struct { // GATHER: is given the estimates that the picture needs, one after the other. NULL: is not called
        void (*take)(void *user, const IrradianceEstimate *estimate);
        void *user;
    } estimates;
} RenderOptions;

#define REUSE_DEFAULT 0.35f

typedef struct {
    int passes; // 0: a picture by itself
    long photons_emitted;
    size_t photons_stored;
    uint64_t photon_rays; // traced by photons
    UnsoundPaths unsound;
    uint64_t eye_rays;                                 // camera, shadow and bounce rays
    double photon_seconds, build_seconds, eye_seconds; // eye_seconds: all that follows the maps,
    double gather_seconds;                             // of which this went into estimates (GATHER)
    size_t estimates;                                  // of irradiance (GATHER)
    size_t map_bytes;
    Ledger ledger;
} RenderStats;

// Renders options->settings.width × height pixels into a fresh image. The same bytes whatever the number of threads.
// Steps must have been loaded (path alone needs none). *stats begins as zeros; a pass adds its own, but for
// ledger and map_bytes, which are the last one's. False when memory is short.
bool render_image(const Scene *scene, const RenderOptions *options, Image *image, RenderStats *stats, Error *error);
