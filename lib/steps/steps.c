#include "steps/steps.h"

Steps steps;
StepState step_states[STEP_COUNT];
static long redraw_caps;

void photonlab_step_not_started(const char *id)
{
    const StepInfo *step = step_find(id);
    if (step)
        step_states[step - step_table] = STEP_NOT_STARTED;
}

void redraw_cap_reached(void)
{
#pragma omp atomic
    redraw_caps++;
}

long redraw_cap_count(void)
{
    return redraw_caps;
}
