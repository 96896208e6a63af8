// What a look at a submission's files tells, before anything is compiled.
#ifndef PHOTONLAB_JUDGE_SUBMISSION_H
#define PHOTONLAB_JUDGE_SUBMISSION_H

#include "judge/grade/grade.h"

// False, with a reason, when there is no such folder. Files that look like steps but lie or are called otherwise than
// one are named on standard error: they would count as not started without a word.
bool submission_look_over(const char *code, Error *error);

// A step that still calls todo() although its file is no longer the empty one: says so in result->message.
void submission_note_todo(const GradeOptions *options, const StepInfo *step, const char *source, StepResult *result);

#endif
