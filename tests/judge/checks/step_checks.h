// Every step's checks, one array a step: tests/steps/<stage>/<id>_<symbol>.c; step_checks.c puts them in order.
#ifndef PHOTONLAB_STEPS_STEP_CHECKS_H
#define PHOTONLAB_STEPS_STEP_CHECKS_H

#include "judge/checks/check.h"
#include "judge/checks/statistics.h"

#define DEFINE_CHECKS(name, ...)                                                                                       \
    const Check name##_checks[] = {__VA_ARGS__};                                                                       \
    const int name##_check_count = (int)(sizeof name##_checks / sizeof *name##_checks);

#define STEP(stage, number, symbol, ...)                                                                               \
    extern const Check symbol##_checks[];                                                                              \
    extern const int symbol##_check_count;
#include "steps/steps.def"

// The picture of the step's stage, one array a set of thresholds (pictures.c).
void plan_picture_1(Plan *plan);
void judge_picture_1(const Results *results, Finding *finding);
void plan_picture_2_source(Plan *plan);
void judge_picture_2_source(const Results *results, Finding *finding);
void plan_picture_2_phong(Plan *plan);
void judge_picture_2_phong(const Results *results, Finding *finding);
void plan_picture_3(Plan *plan);
void judge_picture_3(const Results *results, Finding *finding);
void plan_picture_4(Plan *plan);
void judge_picture_4(const Results *results, Finding *finding);
#define PICTURE_1                                                                                                      \
    {                                                                                                                  \
        "picture", "The picture of stage 1", CHECK_PICTURE, plan_picture_1, judge_picture_1, true                      \
    }
#define PICTURE_2_SOURCE                                                                                               \
    {                                                                                                                  \
        "picture", "The picture of step 2.3", CHECK_PICTURE, plan_picture_2_source, judge_picture_2_source, true       \
    }
#define PICTURE_2_PHONG                                                                                                \
    {                                                                                                                  \
        "picture", "The picture of stage 2", CHECK_PICTURE, plan_picture_2_phong, judge_picture_2_phong, true          \
    }
#define PICTURE_3                                                                                                      \
    {                                                                                                                  \
        "picture", "The picture of stage 3", CHECK_PICTURE, plan_picture_3, judge_picture_3, true                      \
    }

#define PICTURE_4                                                                                                      \
    {                                                                                                                  \
        "picture", "The picture of stage 4", CHECK_PICTURE, plan_picture_4, judge_picture_4, true                      \
    }

#endif
