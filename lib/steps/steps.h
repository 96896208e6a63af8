// The step table: what a student fills in, and where it plugs into the program.
//
// Every step is one function in one source file, built into one shared object. steps_load fills the slots below from
// the reference solutions and, step by step, from a student's objects. Steps call each other through the slots
// (steps.reflect(…)), so any mixture of both runs.
#ifndef PHOTONLAB_STEPS_STEPS_H
#define PHOTONLAB_STEPS_STEPS_H

#include "steps/1_diffuse_photon_map.h"
#include "steps/2_glossy_lobe.h"
#include "steps/3_colour_dispersion.h"

typedef struct {
    Vec3 (*reflect)(Vec3 direction, Vec3 normal);
    Photon (*emit_photon)(const Light *light, Rng *rng);
    Vec3 (*scatter_diffuse)(Vec3 normal, Rng *rng);
    bool (*russian_roulette)(Colour *power, Colour reflectance, Rng *rng);
    void (*trace_photon)(PhotonTrace *trace, Photon photon, Rng *rng);
    Colour (*estimate_radiance)(const PhotonMap *map, const Hit *hit, Vec3 wo, Gather *gather);

    Vec3 (*sample_lobe)(float exponent, Rng *rng);
    Vec3 (*turn_to)(Vec3 local, Vec3 axis);
    bool (*scatter_glossy_source_text)(Vec3 direction, Vec3 normal, float exponent, Rng *rng, Vec3 *out, float *weight);
    bool (*scatter_glossy_phong)(Vec3 direction, Vec3 normal, float exponent, Rng *rng, Vec3 *out, float *weight);

    bool (*refract)(Vec3 direction, Vec3 normal, float eta, Vec3 *refracted);
    float (*fresnel)(float cos_i, float eta);
    float (*refractive_index)(const Material *glass, PhotonColour colour);
    void (*trace_photon_in_colour)(PhotonTrace *trace, Photon photon, Rng *rng);
    int (*split_colour)(const Photon *photon, const Material *glass, Photon children[3]);

    // Step 2.3 or 2.4, whichever is played; photon_scatter_glossy calls this one.
    bool (*scatter_glossy)(Vec3 direction, Vec3 normal, float exponent, Rng *rng, Vec3 *out, float *weight);
} Steps;

extern Steps steps;

#define HINT_COUNT 3

typedef struct {
    const char *id;     // "1.3"
    const char *symbol; // the function's name
    int stage;
    const char *file; // below solutions/ and exercises/, without ending
    const char *title;
    const char *const *hints; // HINT_COUNT of them, each telling more than the one before
    const char *chapter;      // of the course notes, with anchor
    size_t slot;              // offset in Steps
} StepInfo;

#define STEP_COUNT  15
#define STAGE_COUNT 3 // the last step's stage
extern const StepInfo step_table[STEP_COUNT];

// The step of this id; NULL: there is none.
const StepInfo *step_find(const char *id);

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

// For grading one step: its slot from `object`, the others from whatever solutions lie in `references`, laid out as
// StepInfo.file with the ending .so. The graded step's own solution is never loaded; a slot without any solution ends
// the program with a message when it is called.
bool steps_load_graded(const StepInfo *graded, const char *object, const char *references, Error *error);

// The same for several steps together, each from objects/<its id>/step.so.
bool steps_load_several(const bool graded[STEP_COUNT], const char *objects, const char *references, Error *error);

// Which steps play where two do the same work: "2.3" or "2.4" for glossy surfaces, "1.5" or "3.4" for the photon's
// life; several parted by commas. Unset: 2.4 and 3.4.
typedef struct {
    GlossyModel glossy;
    bool loop; // 1.5 in place of 3.4
} StepChoice;
bool step_choice_parse(const char *text, StepChoice *choice, Error *error);

// The choice that lets students see what they have so far: 1.5 or 2.3 where theirs is started, and 3.4 or 2.4 is not.
StepChoice step_choice_for_student(void);

void steps_play(StepChoice choice);
bool step_is_played(const StepInfo *step, StepChoice choice);

// What a stub calls: todo("1.3") marks the step as not started. Take the call away when you start. A name of its own
// in the object tells a stub from code that merely has something called todo.
void photonlab_step_not_started(const char *id);
#define todo(id) photonlab_step_not_started(id)

// Step 2.3 gave up redrawing; counted, and reported by the program.
void redraw_cap_reached(void);
long redraw_cap_count(void);

#endif
