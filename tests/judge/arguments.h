// The judge's command line.
#ifndef PHOTONLAB_JUDGE_ARGUMENTS_H
#define PHOTONLAB_JUDGE_ARGUMENTS_H

#include "base/command_line.h"
#include "judge/grade/grade.h"

#define EXIT_FAILS    1
#define EXIT_UNGRADED 3

typedef struct {
    GradeOptions grade;
    const char *step, *report, *points;
    int stage, jobs, scatters;
    bool credit, strict, features, verbose, lines;
} Arguments;

// 0; or, all said, the exit code or HELP_SHOWN.
int arguments_parse(int count, char **arguments, Arguments *a);

#endif
