#include "steps/steps.h"
#include "base/text.h"

#include <stdio.h>
#include <string.h>

#define MOST_SIDES 3

typedef struct {
    size_t field;                  // offset in StepChoice
    const char *names[MOST_SIDES]; // by the field's value; NULL: no more
} Pair;

#define CHOICE(field, ...) {offsetof(StepChoice, field), {__VA_ARGS__}},
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
    text[0] = '\0';
    for (size_t i = 0; i < PAIR_COUNT; i++)
        text_append(text, size, "%s%s", i > 0 ? "," : "", first_of(&pairs[i], *field_of(&pairs[i], &choice))->id);
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
        for (*side = 0; *side < MOST_SIDES && pairs[i].names[*side]; ++*side)
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

bool step_choice_parse(const char *text, StepChoice *choice, Error *error)
{
    *choice = (StepChoice){0};
    bool chosen[PAIR_COUNT] = {false};
    const char *word = text;
    do {
        char id[16], choices[200] = ""; // "2.4 or 2.3, and 3.4 or 1.5 or 6.4"
        int length = (int)strcspn(word, ","), side;
        snprintf(id, sizeof id, "%.*s", length, word);
        const StepInfo *step = step_find(id);
        const Pair *pair = step ? pair_of(step, &side) : NULL;
        if (!pair || first_of(pair, side) != step || chosen[pair - pairs]) { // each choice may be made once
            for (size_t i = 0; i < PAIR_COUNT; i++)
                for (side = 0; side < MOST_SIDES && pairs[i].names[side]; side++)
                    text_append(choices, sizeof choices, "%s%s",
                                side > 0 ? " or "
                                : i > 0  ? ", and "
                                         : "",
                                first_of(&pairs[i], side)->id);
            return error_set(error, "--steps %s: no choice `%.*s`; expected %s, parted by a comma", text, length, word,
                             choices);
        }
        chosen[pair - pairs] = true;
        *field_of(pair, choice) = side;
        word += length + (word[length] == ',');
    } while (*word);
    return true;
}
