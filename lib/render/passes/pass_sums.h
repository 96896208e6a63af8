// Means over runs of passes, joined two by two by step 5.2, like the digits of a binary counter: two runs of 2^k passes
// become one of 2^(k+1) where the first of them begins at a multiple of that. So N passes need at most log₂ N pictures, and
// which means are joined follows from the passes' numbers alone: passes that were made in parts, by several machines, give
// the same bytes as all in a row.
#ifndef PHOTONLAB_RENDER_PASSES_PASS_SUMS_H
#define PHOTONLAB_RENDER_PASSES_PASS_SUMS_H

#include "image/image.h"

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

#endif
