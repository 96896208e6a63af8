// The image verdict: K pictures by the student's code, each with photons of its own, against the statistics of pictures by
// right code, which `calibrate` made once (tests/reference/pictures/).
//
// Pixels share photons, so they are no independent numbers and have heavy tails: no textbook test keeps its promise here.
// Two statistics are therefore held against what groups of K right pictures really gave, their 99.8 % rank:
//   T   the largest |z| over the means of tiles (8×8, 2×2 and 1×1 to the picture, per channel): a wrong picture
//   V   the logarithm of the pixels' variance over right code's, averaged over tiles: the right picture, but from another
//       estimator (another radius, another kernel)
#pragma once

#include "judge/checks/check.h"

#define PICTURE_TILES    64                            // of the finest grid, 8×8
#define PICTURE_FEATURES ((PICTURE_TILES + 4 + 1) * 3) // tile means: grid by grid, row by row, channel by channel
#define MOST_REPLICATES  32

typedef struct {
    const char *name; // of its files in tests/reference/pictures/
    const char *kind; // as the probe's cases have it: "picture"; or by passes, "passes 7 pixel"
    const char *integrator;
    const char *scene; // from the checkout's root
    int side;          // pixels, a multiple of 8
    long photons;
    int k, depth;
    const char *steps; // as --steps takes it
    int replicates;    // K
    const char *step;  // one of the graded steps; calibrate has the probe play its solution
    bool V_counts;     // for one of its steps; calibrate counts failures so
} PictureSet;

#define PICTURE_SET(set, ...) PICTURE_SET_##set,
enum {
#include "judge/checks/pictures.def"
    PICTURE_SETS
};
extern const PictureSet picture_sets[PICTURE_SETS];
void picture_set_plan(const PictureSet *set, Plan *plan);
void picture_set_judge(const PictureSet *set, bool V_counts, const Results *results, Finding *finding);

// What right code's pictures are like.
typedef struct {
    double mean[PICTURE_FEATURES], spread[PICTURE_FEATURES]; // of one picture's tile means, W/(m²·sr)
    double noise[PICTURE_TILES * 3];                         // the pixels' variance, averaged over each fine tile
    double T;                                                // groups of K stay below, but for 0.2 %
    double V, V_upper; // the same for |log of the variance ratio|, and for the logarithm's upper tail alone
    double V_spread;   // standard deviation of the logarithm over groups
} PictureReference;

// From tests/reference/pictures/<name>.txt below `root`. False, with a reason, when the file is missing, damaged, or was
// made with another scene or other parameters than the set has now. Writing: started in the checkout's root.
bool picture_reference_read(const PictureSet *set, const char *root, PictureReference *reference, Error *error);
bool picture_reference_write(const PictureSet *set, const char *path, const char *head,
                             const PictureReference *reference, Error *error);

// What K pictures give.
typedef struct {
    double mean[PICTURE_FEATURES], z[PICTURE_FEATURES]; // z: in standard errors of the mean of K
    double T;
    int worst;           // the feature that gave T
    double log_variance; // log of the mean over tiles of s²/σ²; V is its magnitude
} PictureScore;

// Tile means of one picture: side × side pixels of three floats.
void picture_features(const float *pixels, int side, double features[PICTURE_FEATURES]);

// The grid of a feature (8, 2 or 1 tiles a side) and where in it.
typedef struct {
    int tiles, row, column, channel;
} PicturePlace;
PicturePlace picture_place(int feature);

// `pictures`: the set's K. A tile without any spread in right pictures (black) gives z = 0 when it is the same here, and
// infinity otherwise.
void picture_score(const PictureSet *set, const PictureReference *reference, const Numbers *pictures,
                   PictureScore *score);
