// What each case gives, and how many numbers that is: the probe keeps to it, and the judge accepts nothing else.
#pragma once

#include "photons/photon_numbers.h"
#include "steps/steps.h"

#include <stdio.h>

#define PROBE_MAGIC "photonlab probe 1\n" // before all cases

// ---- `paths`: for each of its batches the books of one photon pass, number by number in this order (summed as doubles, written as
// floats).
#define BATCH_MATERIALS 6 // the scene's first ones, in the file's order
#define BATCH_COLOURS   4 // PhotonColour
#define BATCH_PATHS     3 // PhotonPath
#define BATCH_BOUNCES   8

// Sums over photons at rest.
typedef struct {
    double count, flux[3], place[3], from[3]; // flux in W, position in m, unit vector to where they came from
} BatchSum;

typedef struct {
    double emitted[3], absorbed[3], escaped[3], cut[3], chance[3], chance_error[3]; // W: a Ledger, field by field
    double segments, unsound;                                                       // see PhotonPass
    double unusual; // photons at rest with a negative power, one that is no number, or of a material beyond those
    BatchSum stored[BATCH_MATERIALS][BATCH_COLOURS];
    BatchSum bounces[BATCH_BOUNCES]; // by surfaces met before; the last: as many or more
    double paths[BATCH_PATHS];       // how many
} Batch;

#define BATCH_NUMBERS (sizeof(Batch) / sizeof(double))

// ---- `scatter`: a head, then as many photons as were asked for, in the order of their paths; behind the last one all is 0.
#define SCATTER_HEAD         (sizeof(PhotonNumbersHead) / sizeof(float))
#define SCATTER_NUMBERS      (sizeof(PhotonNumbers) / sizeof(float))
#define SCATTER_MOST_PHOTONS 1000000L

// ---- `call`: what becomes of one value
enum {
    NUMBERS_bool = 1,
    NUMBERS_int = 1,
    NUMBERS_float = 1,
    NUMBERS_Vec3 = 3,
    NUMBERS_Colour = 3,
    NUMBERS_Photon = 14,
    NUMBERS_PointStatistics = 5,
    NUMBERS_Hemisphere = GATHER_RINGS * GATHER_SECTORS * 4
};

// Numbers of one call of this step; 0: it is not called alone, or there is no such step.
static inline size_t probe_call_size(const StepInfo *step)
{
#define VALUE(type, name)
#define GIVEN(type, name)
#define RNG
#define CHANGED(type, name)                                                          +NUMBERS_##type
#define FILLED_ARRAY(type, name, count)                                              +NUMBERS_##type *count
#define REDRAWS                                                                      +1
#define DRAWS                                                                        +1
#define SCENE_STEP(...)                                                              0,
#define STEP(stage, number, symbol, title, anchor, pass, needs, reader, result, ...) NUMBERS_##result __VA_ARGS__,
    static const size_t sizes[STEP_COUNT] = {
#include "steps/steps.def"
    };
    return step ? sizes[step - step_table] : 0;
}

// Numbers that a case gives, from its line; 0 for a line that is none.
static inline size_t probe_case_size(const char *id, const char *line)
{
    long first, second;
    if (sscanf(line, "call %ld", &first) == 1)
        return (size_t)first * probe_call_size(step_find(id));
    if (sscanf(line, "paths %*s %*d %ld", &first) == 1)
        return (size_t)first * BATCH_NUMBERS;
    if (sscanf(line, "scatter %*s %*d %ld", &first) == 1)
        return SCATTER_HEAD + (size_t)first * SCATTER_NUMBERS;
    if (sscanf(line, "picture %*s %*s %ld %ld", &first, &second) == 2 ||
        sscanf(line, "passes %*d %*s %*s %*s %ld %ld", &first, &second) == 2)
        return (size_t)first * (size_t)second * 3;
    return 0;
}
