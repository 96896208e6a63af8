// From what the probe left behind to words for the person who wrote the step.
#ifndef PHOTONLAB_JUDGE_CRASH_H
#define PHOTONLAB_JUDGE_CRASH_H

#include "judge/submission/submission.h"

// Fills in message and where for a run that did not get through. `object` NULL: several steps ran, and
// the probe says in which of them it was.
void crash_describe(const GradeOptions *options, const SandboxResult *ran, const char *object, const char *symbol,
                    StepWords *words);

#endif
