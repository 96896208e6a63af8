// What a step's object tells before any of its code runs.
#ifndef PHOTONLAB_JUDGE_OBJECT_CHECK_H
#define PHOTONLAB_JUDGE_OBJECT_CHECK_H

#include "judge/grade/grade.h"

// STATUS_TODO: it still calls todo(). STATUS_ERROR: it names what steps must not use (rand, system, …), keeps variables
// between calls, or lacks its function. The message says which.
Status object_check(const GradeOptions *options, const StepInfo *step, const char *source, const char *object,
                    StepResult *result);

#endif
