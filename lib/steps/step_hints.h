// What `make hint` says: three hints a step, each telling more than the one before. The first points the way, the second has
// the formula or the structure, the third is nearly the code.
#ifndef PHOTONLAB_STEPS_STEP_HINTS_H
#define PHOTONLAB_STEPS_STEP_HINTS_H

#include "steps/steps.h"

// In the order of step_table.
extern const char *const step_hints[STEP_COUNT][HINT_COUNT];

#endif
