#include "steps/steps.h"

#include <stdlib.h>
#include <string.h>

Steps steps;
StepState step_states[STEP_COUNT];
static long redraw_caps;

// Each row says what its contract in the stage's header says, or this does not compile.
#define STEP(stage, number, symbol, title, anchor, pass, needs, reader, result, ...)                                   \
    enum { symbol##_has_a_contract = sizeof &symbol };                                                                 \
    result symbol(STEP_PARAMETERS(none __VA_ARGS__));
#include "steps/steps.def"

#define STEP(stage, number, symbol, title, anchor, pass, needs, ...)                                                   \
    {#stage "." #number,                                                                                               \
     #symbol,                                                                                                          \
     stage,                                                                                                            \
     FOLDER "/" #stage "." #number "_" #symbol,                                                                        \
     title,                                                                                                            \
     FOLDER ".html#" anchor,                                                                                           \
     pass,                                                                                                             \
     needs,                                                                                                            \
     offsetof(Steps, symbol)},
const StepInfo step_table[STEP_COUNT] = {
#include "steps/steps.def"
};

#define STAGE(number, scene) scene,
const char *const stage_scenes[STAGE_COUNT] = {
#include "steps/steps.def"
};

const StepInfo *step_find(const char *id)
{
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (strcmp(step_table[i].id, id) == 0)
            return &step_table[i];
    return NULL;
}

size_t step_count_of(int stages)
{
    size_t count = 0;
    while (count < STEP_COUNT && (stages == 0 || step_table[count].stage <= stages))
        count++;
    return count;
}

bool step_is_listed(const char *list, const char *id)
{
    for (size_t length; *list; list += length + (list[length] != '\0')) {
        length = strcspn(list, " ,");
        if (length == strlen(id) && strncmp(list, id, length) == 0)
            return true;
    }
    return false;
}

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
