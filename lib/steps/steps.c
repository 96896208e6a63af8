#include "steps/steps.h"
#include "base/file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DIVIDER        "----\n" // a line between two hints
#define MOST_HINT_SIZE 100000

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

// From the library's directory up, the first that has this step's hints below it.
static char *read_hints(const StepInfo *step, Error *error)
{
    char directory[2048], path[4096];
    size_t size;
    steps_library_directory(directory, sizeof directory);
    for (char *end = directory + strlen(directory); end; end = strrchr(directory, '/')) {
        *end = '\0';
        snprintf(path, sizeof path, "%s/lib/steps/hints/%s.txt", directory, strchr(step->file, '/') + 1);
        char *text = file_read(path, MOST_HINT_SIZE, &size, NULL);
        if (text)
            return text;
    }
    snprintf(path, sizeof path, "lib/steps/hints/%s.txt", strchr(step->file, '/') + 1);
    return file_read(path, MOST_HINT_SIZE, &size, error);
}

char *step_hint(const StepInfo *step, int level, Error *error)
{
    char *text = read_hints(step, error), *part = text;
    for (int i = 1; part && i < level; i++) {
        part = strstr(part, DIVIDER);
        part = part ? part + strlen(DIVIDER) : NULL;
    }
    if (!part) {
        error_set(error, "step %s: its hints have no part %d", step->id, level);
        free(text);
        return NULL;
    }
    char *end = strstr(part, DIVIDER);
    if (end)
        *end = '\0';
    memmove(text, part, strlen(part) + 1);
    return text;
}
