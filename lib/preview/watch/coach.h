// The coach: how the steps are coming on: each save is judged, one at a time, and one step is the present one. The
// window's panel and the browser's show it.
#pragma once

#include "preview/record/verdicts.h"
#include "preview/watch/job.h"

typedef struct {
    const char *judging; // sh -c JUDGING sh ID prints the step's line, as `judge --lines` does; NULL: nobody judges
    Verdicts verdicts;
    int stage;              // whose steps come first; 0: any
    bool stated;            // which steps are started is known
    int hints[STEP_COUNT];  // given
    int wanted[STEP_COUNT]; // to be judged: the lowest number above 0 comes next; 0: is not wanted
    int last, first;        // numbers given
    size_t judged;          // the step that the judge is at
    Job judge;
} Coach;

// `judging` has to stay. `stages`: of the course; 0: all.
void coach_start(Coach *coach, const char *judging, int stage, int stages);
void coach_stop(Coach *coach);

// Which steps are started; and those that nobody has judged yet are to be.
void coach_note_states(Coach *coach, const StepState states[STEP_COUNT]);
// It was saved: it is the present step now, and judged. Or it does not compile.
void coach_judge(Coach *coach, const StepInfo *step);
void coach_note_broken(Coach *coach, const StepInfo *step, const char *message);
// Never waits. True: there is a verdict, which the terminal is told.
bool coach_poll(Coach *coach);

// On to this step; to the next that is not right. NULL where nobody judges. A hint for the present one; each call tells more.
const StepInfo *coach_go_to(Coach *coach, size_t step);
const StepInfo *coach_next(Coach *coach);
void coach_hint(Coach *coach);
