// How many numbers each case gives: the probe keeps to it, and the judge accepts nothing else.
#ifndef PHOTONLAB_PROBE_SIZES_H
#define PHOTONLAB_PROBE_SIZES_H

#include "judge/probe/probe_batch.h"
#include "judge/probe/probe_scatter.h"

#include "steps/steps.h"

#include <stdio.h>

#define PROBE_MAGIC "photonlab probe 1\n" // before all cases

// What becomes of one value.
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

#endif
