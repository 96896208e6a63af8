// Features as text: one line a step and check, for the table of known mistakes (tests/mistakes/features.txt).
//   STEP STATUS NAME:value:error …      NAME is the check's, once for each of its features
#ifndef PHOTONLAB_JUDGE_FEATURES_H
#define PHOTONLAB_JUDGE_FEATURES_H

#include "judge/grade/grade.h"

#include <stdio.h>

void features_print(FILE *stream, const StepResult *results, int count);

#endif
