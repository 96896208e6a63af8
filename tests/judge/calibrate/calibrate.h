// The parts of `calibrate`: reference.c makes the files, measure.c counts failures.
#ifndef PHOTONLAB_JUDGE_CALIBRATE_H
#define PHOTONLAB_JUDGE_CALIBRATE_H

#include "groups.h"

typedef struct {
    const char *build, *out, *step, *object, *name;
    long renders, groups, measure, seed;
    int jobs;
} Arguments;

enum { PURPOSE_SPREAD, PURPOSE_THRESHOLDS, PURPOSE_MEASURE };

// Each purpose and each set has pictures of its own.
// Plays a->object, or the solution.
GroupRun group_run(const Arguments *a, const PictureSet *set, uint64_t purpose, long groups);

void sort(double *values, long count);

// Writes a set's files and says what it found. False, having said why, when that fails.
bool calibrate_set(const Arguments *a, const PictureSet *set);

// Judges fresh groups and prints one line, and the first failure's message.
bool measure_set(const Arguments *a, const PictureSet *set);

#endif
