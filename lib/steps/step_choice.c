#include "steps/steps.h"

#include <stdio.h>
#include <string.h>

typedef struct {
    size_t field;         // offset in StepChoice
    const char *names[2]; // the later, the earlier: by the field's value
} Pair;

#define PAIR(field, earlier, later) {offsetof(StepChoice, field), {later, earlier}},
static const Pair pairs[] = {
#include "steps/steps.def"
};
#define PAIR_COUNT (sizeof pairs / sizeof *pairs)

static int *field_of(const Pair *pair, StepChoice *choice)
{
    return (int *)((char *)choice + pair->field);
}

// Whose name stands for the whole side: 3.4 for "3.4 3.5".
static const StepInfo *first_of(const Pair *pair, int side)
{
    char id[16];
    snprintf(id, sizeof id, "%.*s", (int)strcspn(pair->names[side], " "), pair->names[side]);
    return step_find(id);
}

void step_choice_print(StepChoice choice, char *text, size_t size)
{
    size_t used = 0;
    for (size_t i = 0; i < PAIR_COUNT && used < size; i++)
        used += (size_t)snprintf(text + used, size - used, "%s%s", i > 0 ? "," : "",
                                 first_of(&pairs[i], *field_of(&pairs[i], &choice))->id);
}

StepChoice step_choice_for(const bool started[STEP_COUNT])
{
    StepChoice choice = {0};
    for (size_t i = 0; i < PAIR_COUNT; i++) {
        bool later = started[first_of(&pairs[i], 0) - step_table],
             earlier = started[first_of(&pairs[i], 1) - step_table];
        *field_of(&pairs[i], &choice) = earlier && !later;
    }
    return choice;
}

StepChoice step_choice_for_student(void)
{
    bool started[STEP_COUNT];
    for (int i = 0; i < STEP_COUNT; i++)
        started[i] = step_states[i] == STEP_STUDENT;
    return step_choice_for(started);
}

void steps_play(StepChoice choice)
{
    steps.scatter_glossy = choice.glossy ? steps.scatter_glossy_source_text : steps.scatter_glossy_phong;
}

// The pair that the step is in, and on which side; NULL: it has its work to itself.
static const Pair *pair_of(const StepInfo *step, int *side)
{
    for (size_t i = 0; i < PAIR_COUNT; i++)
        for (*side = 0; *side < 2; ++*side)
            if (step_is_listed(pairs[i].names[*side], step->id))
                return &pairs[i];
    return NULL;
}

bool step_is_played(const StepInfo *step, StepChoice choice)
{
    int side;
    const Pair *pair = pair_of(step, &side);
    return !pair || *field_of(pair, &choice) == side;
}

const StepInfo *step_chosen_by(const StepInfo *step)
{
    int side;
    const Pair *pair = pair_of(step, &side);
    return pair ? first_of(pair, side) : step;
}

bool steps_are_paired(const StepInfo *step, const StepInfo *other)
{
    int side, other_side;
    const Pair *pair = pair_of(step, &side);
    return pair && pair == pair_of(other, &other_side) && side != other_side;
}

// Takes one word of the list; each choice may be made once.
static bool choose(const char *word, size_t length, StepChoice *choice, bool chosen[PAIR_COUNT])
{
    for (size_t i = 0; i < PAIR_COUNT; i++)
        for (int side = 0; side < 2; side++) {
            const char *id = first_of(&pairs[i], side)->id;
            if (chosen[i] || length != strlen(id) || strncmp(word, id, length) != 0)
                continue;
            chosen[i] = true;
            *field_of(&pairs[i], choice) = side;
            return true;
        }
    return false;
}

// "2.3 or 2.4, and 1.5 or 3.4"
static void list_choices(char *text, size_t size)
{
    size_t used = 0;
    for (size_t i = 0; i < PAIR_COUNT && used < size; i++)
        used += (size_t)snprintf(text + used, size - used, "%s%s or %s", i > 0 ? ", and " : "",
                                 first_of(&pairs[i], 1)->id, first_of(&pairs[i], 0)->id);
}

bool step_choice_parse(const char *text, StepChoice *choice, Error *error)
{
    *choice = (StepChoice){0};
    bool chosen[PAIR_COUNT] = {false};
    const char *word = text;
    do {
        size_t length = strcspn(word, ",");
        if (!choose(word, length, choice, chosen)) {
            char choices[200];
            list_choices(choices, sizeof choices);
            return error_set(error, "--steps %s: no choice `%.*s`; expected %s, parted by a comma", text, (int)length,
                             word, choices);
        }
        word += length + (word[length] == ',');
    } while (*word);
    return true;
}
