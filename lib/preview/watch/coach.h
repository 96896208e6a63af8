// The coach: how the steps are coming on: each save is judged, and one step is the present one. The window's panel and the browser's show it.
#ifndef PHOTONLAB_PREVIEW_COACH_H
#define PHOTONLAB_PREVIEW_COACH_H

#include "preview/watch/judging.h"

typedef struct {
    Judging *judging; // NULL: nobody judges, and there are no verdicts
    Verdicts verdicts;
    int stage;             // whose steps come first; 0: any
    bool stated;           // which steps are started is known
    int hints[STEP_COUNT]; // given
} Coach;

// `command`: NULL: nobody judges. `stages`: of the course; 0: all. False: memory is short.
bool coach_start(Coach *coach, const char *command, int stage, int stages);
void coach_stop(Coach *coach);

// Which steps are started; and those that nobody has judged yet are to be.
void coach_note_states(Coach *coach, const StepState states[STEP_COUNT]);
// It was saved: it is the present step now, and judged. Or it does not compile.
void coach_judge(Coach *coach, const StepInfo *step);
void coach_note_broken(Coach *coach, const StepInfo *step, const char *message);
// True: there is a verdict, which the terminal is told.
bool coach_poll(Coach *coach);

// On to this step; to the next that is not right. NULL where nobody judges. A hint for the present one; each call tells more.
const StepInfo *coach_go_to(Coach *coach, size_t step);
const StepInfo *coach_next(Coach *coach);
void coach_hint(Coach *coach);

#endif
