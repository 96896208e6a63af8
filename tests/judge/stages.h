// The scatters of all stages that were asked for.
#ifndef PHOTONLAB_JUDGE_STAGES_H
#define PHOTONLAB_JUDGE_STAGES_H

#include "arguments.h"
#include "judge/scatter/scatter.h"

// All steps of a stage together; not where one step alone is asked for. Fills STAGE_COUNT of them, zeroed before.
void stages_grade(const Arguments *a, const StepResult *results, int count, StageResult *stages);

// Compiles the steps and prints a line per stage and salt: how often right code is called wrong, and which mistakes are
// seen. Returns the exit code.
int stages_measure(const Arguments *a, StepResult *results, int count);

#endif
