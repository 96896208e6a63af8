// The table of known mistakes, and which of them a step's features look like.
//
// tests/mistakes/features.txt, made by `make mistakes-table` from the a patches. Three lines an entry:
//   STEP NAME                     "2.1 n_for_n_plus_1"; the name `right` is the solution
//   what it looks like            completes "this looks like: …"
//   CHECK:value:error …           the features in the order of the checks; values may be nan or inf
#ifndef PHOTONLAB_JUDGE_DIAGNOSIS_H
#define PHOTONLAB_JUDGE_DIAGNOSIS_H

#include "judge/grade/grade.h"

#include <stdio.h>

typedef struct {
    char check[32];
    Feature feature;
} NamedFeature;

// What the checks of one step measured, one after the other.
typedef struct {
    char step[8], name[64], text[300];
    NamedFeature *features;
    int count, capacity;
} Signature;

void signature_add(Signature *signature, const char *check, Feature feature);
void signature_of(const StepResult *result, Signature *signature);
void signature_free(Signature *signature);

// Reads the next entry. False at the end of the file, or where an entry is broken.
bool signature_read(FILE *stream, Signature *signature);

// How far two signatures are apart: the worst feature, in tolerances. Up to 1 they agree.
double signature_distance(const Signature *a, const Signature *b);

#endif
