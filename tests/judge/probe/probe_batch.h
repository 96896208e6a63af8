// What a `paths` case gives for each of its batches: the books of one photon pass, number by number in this order
// (summed as doubles, written as floats). Written by probe_paths.c, read by tests/judge/checks/path_batches.c.
#ifndef PHOTONLAB_CLI_PROBE_BATCH_H
#define PHOTONLAB_CLI_PROBE_BATCH_H

#define BATCH_MATERIALS 6 // the scene's first ones, in the file's order
#define BATCH_COLOURS   4 // PhotonColour
#define BATCH_PATHS     3 // PhotonPath
#define BATCH_BOUNCES   8

// Sums over photons at rest.
typedef struct {
    double count, flux[3], place[3], from[3]; // flux in W, position in m, unit vector to where they came from
} BatchSum;

typedef struct {
    double emitted[3], absorbed[3], escaped[3], cut[3], chance[3], chance_error[3]; // W; see Ledger
    double segments, unsound;                                                       // see PhotonPass
    double unusual; // photons at rest with a negative power, one that is no number, or of a material beyond those
    BatchSum stored[BATCH_MATERIALS][BATCH_COLOURS];
    BatchSum bounces[BATCH_BOUNCES]; // by surfaces met before; the last: as many or more
    double paths[BATCH_PATHS];       // how many
} Batch;

#define BATCH_NUMBERS (sizeof(Batch) / sizeof(double))

#endif
