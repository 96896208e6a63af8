// The cells in which photons are counted and measured, batch by batch of paths.
#ifndef PHOTONLAB_JUDGE_SCATTER_CELLS_H
#define PHOTONLAB_JUDGE_SCATTER_CELLS_H

#include "judge/scatter/scatter.h"

#define BATCHES 60
#define BOUNCES 9 // the last: as many or more

enum {
    CELLS_MATERIAL = 1, // 0: all of the scene
    CELLS_PATH = CELLS_MATERIAL + SCATTER_MOST_MATERIALS,
    CELLS_ON_PATH = CELLS_PATH + 3,
    CELLS_IN_COLOUR = CELLS_ON_PATH + 3 * SCATTER_MOST_MATERIALS,
    CELLS_BOUNCE = CELLS_IN_COLOUR + 4 * SCATTER_MOST_MATERIALS,
    CELLS = CELLS_BOUNCE + BOUNCES
};

enum { COUNT = 0, FLUX = 1, PLACE = 4, WAY = 7, SPREAD = 10, SUMS = 13 };

typedef struct {
    double count, hits, last;    // last: path that was here
    double mean[SUMS];           // per photon, of this side
    double batch[BATCHES][SUMS]; // centred sums
} Cell;

typedef struct {
    Cell cells[CELLS];
} Side; // the student's, or the reference's

typedef struct {
    const float *numbers;
    long count, emitted;
} Photons;

// False: the numbers are none that the probe writes.
bool photons_take(const float *numbers, long room, long emitted, Photons *photons);
// How many have a place or a power that is no number, or a power below 0.
long photons_count_odd(const Photons *photons);
// Fills both sides, which are zeroed. Places, ways and spreads are centred at what both have on average, so that a sum over a
// batch tells of where its photons are, not of how many there are.
void cells_fill(const Photons photons[2], Side *sides[2]);
ScatterCell cell_describe(int cell);

#endif
