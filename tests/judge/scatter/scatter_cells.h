// The cells in which photons are counted and measured, batch by batch of paths.
#pragma once

#include "judge/scatter/scatter.h"

#define BATCHES 60
#define BOUNCES 9 // the last: as many or more

// What is summed of the photons of a cell; spread: squares of the distance from the mean place along each axis.
typedef union {
    struct {
        double count, flux[3], place[3], way[3], spread[3];
    } of;
    double all[13];
} Measures;
#define MEASURES       (sizeof(Measures) / sizeof(double))
#define MEASURE(which) (offsetof(Measures, of.which) / sizeof(double))

typedef struct {
    double count, hits, last; // last: path that was here
    Measures mean;            // per photon, of this tally
    Measures batch[BATCHES];  // centred sums
} Cell;

// Which cells there are. A cell's number is its place in this row; CELL(bounce) is that of the first bounce.
typedef struct {
    Cell scene;
    Cell material[SCATTER_MOST_MATERIALS];
    Cell path[3];
    Cell path_on_material[SCATTER_MOST_MATERIALS][3];
    Cell colour_on_material[SCATTER_MOST_MATERIALS][4];
    Cell bounce[BOUNCES];
} CellRow;
#define CELLS       ((int)(sizeof(CellRow) / sizeof(Cell)))
#define CELL(which) ((int)(offsetof(CellRow, which) / sizeof(Cell)))

typedef struct {
    Cell cells[CELLS];
} Tally; // of the student's photons, or of the reference's

// Fills both tallies, which are zeroed. Places, ways and spreads are centred at what both have on average, so that a sum over a
// batch tells of where its photons are, not of how many there are.
void cells_fill(const ScatterPhotons *const photons[2], Tally *tallies[2]);
ScatterCell cell_describe(int cell);
