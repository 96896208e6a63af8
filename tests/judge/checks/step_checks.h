// Every step's checks, one array a step: tests/steps/<stage>/<id>_<symbol>.c; grade/grade.c puts them in order.
#pragma once

#include "judge/checks/check.h"
#include "judge/checks/statistics.h"

#define DEFINE_CHECKS(name, ...)                                                                                       \
    const Check name##_checks[] = {__VA_ARGS__};                                                                       \
    const int name##_check_count = (int)(sizeof name##_checks / sizeof *name##_checks);

#define STEP(stage, number, symbol, ...)                                                                               \
    extern const Check symbol##_checks[];                                                                              \
    extern const int symbol##_check_count;
#include "steps/steps.def"

// A step's picture (pictures.h). V counts for steps 1.6, 5.1 and 5.2, to which the reference gives the
// photons: nothing that is theirs to choose makes other noise.
#define PICTURE_SET(set, ...)                                                                                          \
    extern const char picture_title_##set[];                                                                           \
    void plan_picture_##set(Plan *plan);                                                                               \
    void judge_picture_##set(const Results *results, Finding *finding);                                                \
    void judge_picture_and_v_##set(const Results *results, Finding *finding);
#include "judge/checks/pictures.def"
#define PICTURE_CHECK(set, judge) {"picture", picture_title_##set, CHECK_PICTURE, plan_picture_##set, judge##_##set}
#define PICTURE(set)              PICTURE_CHECK(set, judge_picture)
#define PICTURE_AND_V(set)        PICTURE_CHECK(set, judge_picture_and_v)
