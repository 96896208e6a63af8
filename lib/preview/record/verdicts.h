// What the judge says of every step: the content of the panel, wherever it is drawn.
#pragma once

#include "steps/steps.h"

typedef enum {
    VERDICT_NONE, // nobody has looked yet
    VERDICT_PASS,
    VERDICT_FAIL,
    VERDICT_ERROR, // does not compile, crashes, does not end
    VERDICT_TODO,  // not started
    VERDICT_SKIP,  // the judge could not judge it
    VERDICT_STATES
} VerdictState;
extern const char *const verdict_marks[VERDICT_STATES]; // "✓"

typedef struct {
    VerdictState state;
    bool old;        // of code that is no longer there
    bool judged_now; // another is on its way
    char message[1024], where[256], looks_like[300];
} Verdict;

typedef struct {
    Verdict steps[STEP_COUNT];
    size_t count;   // of the steps of the course; the others are in no panel, and never come next
    size_t present; // that is worked on
    char hint[1200];
} Verdicts;

// Takes what the judge says of a step in a line of its --lines; NULL when it is none.
const StepInfo *verdicts_take_line(Verdicts *verdicts, const char *line);

// The step to go on with: the next that is not right, round and round. The present one: there is no other.
size_t verdicts_next(const Verdicts *verdicts);
bool verdicts_all_right(const Verdicts *verdicts);
