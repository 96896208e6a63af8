// Many groups of pictures by one step's code: `build/probe` draws them, as it does when a step is graded.
#ifndef PHOTONLAB_JUDGE_CALIBRATE_GROUPS_H
#define PHOTONLAB_JUDGE_CALIBRATE_GROUPS_H

#include "judge/checks/pictures.h"

typedef struct {
    const PictureSet *set;
    const char *build;         // where photonlab and solutions/ lie
    const char *step, *object; // the step that is played, and its shared object
    uint64_t seed;             // another seed, other pictures
    long groups;
    int jobs; // probes side by side; 0: one per core
} GroupRun;

// Calls `each` with every group's pictures; groups come in any order, and from several threads at once. False when a
// probe fails: it has then said why on standard error.
bool groups_run(const GroupRun *run, void (*each)(long group, const Results *pictures, void *data), void *data);

#endif
