// The scatter of a stage: where photons come to rest when all of a student's steps of the stage play together, held
// against where the reference's do. Worth no points of its own: it shows what the steps make of a scene, and catches
// those that are right alone and wrong together.
#pragma once

#include "judge/grade/grade.h"
#include "photons/photon_numbers.h"

// What the probe gave for one pass.
typedef struct {
    float *numbers; // owns them; NULL: nothing
    PhotonNumbersHead head;
    const PhotonNumbers *items;
    long count;
} ScatterPhotons;

typedef struct {
    int stage;          // 0: not asked for
    Status status;      // STATUS_TODO: no step that a photon meets is started, nothing was run
    char message[1024]; // one sentence: what differs most, or what went wrong
    char steps[100];    // of the student, that played: "2.1 2.4"
    double p;           // the smallest p-value; its threshold; how many there were
    double threshold;
    int tests;
    double seconds;
    ScatterPhotons yours, reference; // of the first round
    char picture[64];                // both side by side: path below the report's directory; empty: there is none
    char picture_message[300];       // why not
} StageResult;

// Runs and judges the stage with those of the graded steps that are `playable` and not hidden, the reference's for the
// rest. Never fails as a function.
void grade_scatter(const GradeOptions *options, int stage, const StepResult *graded, int count, StageResult *result);
void stage_result_free(StageResult *result);

// Writes directory/pictures/scatter_N.png by `photonlab preview`, which needs no display.
void scatter_draw(const GradeOptions *options, const char *directory, StageResult *result);

// Where a stage's photons fly.
typedef struct {
    const char *scene; // from the root; NULL: this stage has none, and is judged by its steps alone
    long photons;      // emitted; some 30,000 to 40,000 come to rest
    int depth;
    const char *colour; // of the picture's points: what `photonlab preview --colour` takes
} ScatterStage;
extern const ScatterStage scatter_stages[STAGE_COUNT];
#define SCATTER_MOST 60000L // photons that are kept of one pass

// ---- scatter_compare.c

#define SCATTER_MOST_MATERIALS 12

// What the photons in the result say: p, 0 for what right code never does, whatever its random numbers; how many tests there were;
// the message of the smallest p. `scene`: for its materials' names.
void scatter_compare(StageResult *result, const Scene *scene);

// ---- scatter_words.c

typedef struct {
    int material; // −1: all
    int path, colour, bounce;
} ScatterCell;
typedef enum { SCATTER_HITS, SCATTER_COUNT, SCATTER_FLUX, SCATTER_PLACE, SCATTER_SPREAD, SCATTER_WAY } ScatterStat;

// What was found in this cell, in a sentence without its full stop. `axis`: of the channel or coordinate.
void scatter_describe(const ScatterCell *cell, ScatterStat stat, int axis, double yours, double reference, double z,
                      const Scene *scene, char *text, size_t size);
