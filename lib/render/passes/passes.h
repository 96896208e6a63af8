// A picture by passes (stage 5): each has photons of its own, which are forgotten after it, and a smaller radius than the one
// before. Memory is that of one pass and of a few pictures, however many there are.
//
//   Passes passes = {.alpha = PASS_ALPHA, .last = 64};
//   passes_run(scene, &options, &passes, &stats, &error);
//   passes_picture(&passes, &image, &error);
//   …
//   passes_free(&passes);
#pragma once

#include "render/render.h"

#define PASS_ALPHA (2.0f / 3.0f)

// Means over runs of passes, joined two by two by step 5.2, like the digits of a binary counter: two runs of 2^k passes
// become one of 2^(k+1) where the first of them begins at a multiple of that. So N passes need at most log₂ N pictures, and
// which means are joined follows from the passes' numbers alone: passes that were made in parts, by several machines, give
// the same bytes as all in a row.
typedef struct {
    int first, count; // passes first … first+count−1
    Image mean;
} PassRun;

#define MOST_RUNS 64 // of any range of passes, as many as int counts

typedef struct {
    PassRun runs[MOST_RUNS]; // in the order of passes, without a gap
    int count;
} PassSums;

// Puts a run behind the others, where it has to begin, and takes over its picture.
void pass_sums_add(PassSums *sums, PassRun run);

// The mean over all passes, as a picture of its own. False when there is no memory for it.
bool pass_sums_mean(const PassSums *sums, Image *mean, Error *error);

void pass_sums_free(PassSums *sums);

typedef struct Passes {
    int first, last; // the passes first … last−1, counted from 0, are wanted
    float alpha;
    bool by_pixel; // a radius for each pixel by what it finds (5.3, 5.4) and not for each pass by its number (5.1)
    int done;      // of them
    int samples;   // eye rays a pixel in each: passes_run takes it from its options
    float radius;  // m, of pass 0; 0: as options->settings.radius has it, or else as passes_run finds it
    PassSums sums; // by_pixel: what does not come by photons
    PointStatistics *points; // by_pixel: one a pixel
    // After each pass. False: no more.
    bool (*heard)(void *user, const struct Passes *passes);
    void *user;
} Passes;

// Goes on from what is done. False when memory is short, or a step gives no radius; what was done before is still there.
// stats: sums over these passes, but the ledger is the last one's.
bool passes_run(const Scene *scene, const RenderOptions *options, Passes *passes, RenderStats *stats, Error *error);

// The picture after passes->done > 0 passes.
bool passes_picture(const Passes *passes, Image *image, Error *error);

void passes_free(Passes *passes);
