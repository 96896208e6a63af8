// The parts of `calibrate`: groups.c draws pictures, reference.c makes the files, measure.c counts failures.
#pragma once

#include "judge/checks/pictures.h"

typedef struct {
    const char *build, *out, *step, *object, *name;
    long renders, groups, measure, seed;
    int jobs;
} Arguments;

enum { PURPOSE_SPREAD, PURPOSE_THRESHOLDS, PURPOSE_MEASURE };

// Many groups of a set's pictures by a->object, or the solution: `build/probe` draws them, as it does when a step is graded. Each
// purpose and each set has pictures of its own. Calls `each` with every group's; groups come in any order, and from several threads
// at once. False when a probe fails: it has then said why on standard error.
bool groups_run(const Arguments *a, const PictureSet *set, uint64_t purpose, long groups,
                void (*each)(long group, const Results *pictures, void *data), void *data);

// Writes a set's files and says what it found. False, having said why, when that fails.
bool calibrate_set(const Arguments *a, const PictureSet *set);

// Judges fresh groups and prints one line, and the first failure's message.
bool measure_set(const Arguments *a, const PictureSet *set);
