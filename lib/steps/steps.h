// The step table: what a student fills in, and where it plugs into the program.
//
// Every step is one function in one source file, built into one shared object. steps_load fills the slots below from
// the reference solutions and, step by step, from a student's objects. Steps call each other through the slots
// (steps.reflect(…)), so any mixture of both runs.
#pragma once

#include "steps/steps.def" // the contracts

#include "base/error.h"

#include <stddef.h>

// A row's parameters, without the comma that they begin with.
#define STEP_BEHIND(none, ...) __VA_ARGS__
#define STEP_PARAMETERS(...)   STEP_BEHIND(__VA_ARGS__)

#define STEP(stage, number, symbol, title, anchor, pass, needs, reader, result, ...)                                   \
    result (*symbol)(STEP_PARAMETERS(none __VA_ARGS__));
typedef struct {
#include "steps/steps.def"
    // Step 2.3 or 2.4, whichever is played; photon_scatter_glossy calls this one.
    bool (*scatter_glossy)(Vec3 direction, Vec3 normal, float exponent, Rng *rng, Vec3 *out, float *weight);
} Steps;

extern Steps steps;

typedef enum { PHOTON_PASS, EYE_PASS } StepPass;

typedef struct {
    const char *id;     // "1.3"
    const char *symbol; // the function's name
    int stage;
    const char *file; // below solutions/ and exercises/, without ending
    const char *title;
    const char *chapter; // of the course notes, with anchor
    StepPass pass;       // when it plays
    const char *needs;   // steps that it may call while it is graded alone, parted by blanks
    size_t slot;         // offset in Steps
} StepInfo;

#define STEP(stage, number, symbol, ...) STEP_##symbol,
enum {
#include "steps/steps.def"
    STEP_COUNT
};
#define STAGE(number, scene) STAGE_##number,
enum {
#include "steps/steps.def"
    STAGE_COUNT
};
extern const StepInfo step_table[STEP_COUNT];
extern const char *const stage_scenes[STAGE_COUNT]; // that show a stage, from stage 1 on

// The step of this id; NULL: there is none.
const StepInfo *step_find(const char *id);

// How many steps the first stages have, which the table begins with. 0: all.
size_t step_count_of(int stages);

// Is the id one of the list's words, which blanks or commas part? 1.1 is not in "1.10".
bool step_is_listed(const char *list, const char *id);

#define HINT_COUNT 3

// One of its hints, each telling more than the one before: 1 points the way, 2 has the formula or the structure, 3 is
// nearly the code. From lib/steps/hints/; to be freed. NULL: it cannot be read.
char *step_hint(const StepInfo *step, int level, Error *error);

typedef enum {
    STEP_REFERENCE,   // no object of the student: the solution plays
    STEP_NOT_STARTED, // the student's object still calls todo(): the solution plays in its place
    STEP_STUDENT      // the student's object plays
} StepState;

extern StepState step_states[STEP_COUNT];

// Fills every slot: from `student_dir` (NULL: none) where it holds a started step, otherwise from the reference
// solutions, <directory of the library>/solutions. Both are laid out as StepInfo.file with the ending .so. False,
// naming step and file, when an object cannot be loaded, lacks its function, or no object is found for a step; when
// student_dir is no directory, or holds a .so that is named like no step.
bool steps_load(const char *student_dir, Error *error);

// The directory that this library lies in, so that solutions and hints are found from wherever the program is started.
void steps_library_directory(char *directory, size_t size);

// Fills one slot from this object.
bool steps_load_slot(const StepInfo *step, const char *path, Error *error);

// Which steps play where several do the same work, as the choices of steps.def have it: "2.3" or "2.4" for glossy surfaces,
// "1.5", "3.4" or "6.4" for the photon's life; several parted by commas. Unset: 2.4 and 3.4.
#define CHOICE(field, ...) int field; // which of them; 0: the first
typedef struct {
#include "steps/steps.def"
} StepChoice;
enum { LOOP_COLOUR, LOOP_PLAIN, LOOP_WAVELENGTH }; // of StepChoice.loop: 3.4, 1.5, 6.4
bool step_choice_parse(const char *text, StepChoice *choice, Error *error);
void step_choice_print(StepChoice choice, char *text, size_t size); // as it is parsed

// The choice that lets students see what they have so far: 1.5 or 2.3 where theirs is started, and 3.4 or 2.4 is not. Never 6.4,
// which --spectral asks for.
StepChoice step_choice_for(const bool started[STEP_COUNT]);
StepChoice step_choice_for_student(void);

void steps_play(StepChoice choice);
bool step_is_played(const StepInfo *step, StepChoice choice);

// The one to name in --steps so that this step plays.
const StepInfo *step_chosen_by(const StepInfo *step);

// Does one play in the other's place?
bool steps_are_paired(const StepInfo *step, const StepInfo *other);

// What a stub calls: todo("1.3") marks the step as not started. Take the call away when you start. A name of its own
// in the object tells a stub from code that merely has something called todo.
void photonlab_step_not_started(const char *id);
#define todo(id) photonlab_step_not_started(id)

// Step 2.3 gave up redrawing; counted, and reported by the program.
void redraw_cap_reached(void);
long redraw_cap_count(void);
