// The judge's command line.
#ifndef PHOTONLAB_JUDGE_ARGUMENTS_H
#define PHOTONLAB_JUDGE_ARGUMENTS_H

#include "judge/grade/grade.h"

#define EXIT_FAILS    1
#define EXIT_USAGE    2
#define EXIT_UNGRADED 3

typedef struct {
    GradeOptions grade;
    const char *step, *report, *points;
    int stage, jobs, scatters;
    int credit, strict, features, verbose;
} Arguments;

// 0, or the exit code after a message. --help prints and exits.
int arguments_parse(int count, char **arguments, Arguments *a);

#endif
