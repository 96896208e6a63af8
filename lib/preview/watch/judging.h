// Has steps judged beside the preview, one at a time: the judge runs as a program of its own, and what it says of the step goes
// into the verdicts.
#ifndef PHOTONLAB_PREVIEW_JUDGING_H
#define PHOTONLAB_PREVIEW_JUDGING_H

#include "preview/record/verdicts.h"

typedef struct Judging Judging;

// `command`: sh -c COMMAND sh ID prints the step's line, as `judge --lines` does. NULL when memory is short.
Judging *judging_start(const char *command);
void judging_stop(Judging *judging);

// Its verdict is wanted: soon, or after those that are wanted already. What it says of it at present is old.
void judging_want(Judging *judging, Verdicts *verdicts, size_t step, bool soon);

// Never waits. The step that there is a verdict of now; NULL: none.
const StepInfo *judging_poll(Judging *judging, Verdicts *verdicts);

#endif
