// Every step's checks, one array a step; step_checks.c puts them in order.
#ifndef PHOTONLAB_STEPS_STEP_CHECKS_H
#define PHOTONLAB_STEPS_STEP_CHECKS_H

#include "judge/checks/check.h"
#include "judge/checks/statistics.h"

#define DECLARE_CHECKS(name)                                                                                           \
    extern const Check name##_checks[];                                                                                \
    extern const int name##_check_count;
#define DEFINE_CHECKS(name, ...)                                                                                       \
    const Check name##_checks[] = {__VA_ARGS__};                                                                       \
    const int name##_check_count = (int)(sizeof name##_checks / sizeof *name##_checks);

DECLARE_CHECKS(reflect)                    // 1_reflect.c
DECLARE_CHECKS(emit_photon)                // 1_emit_photon.c
DECLARE_CHECKS(scatter_diffuse)            // 1_scatter_diffuse.c
DECLARE_CHECKS(russian_roulette)           // 1_russian_roulette.c
DECLARE_CHECKS(trace_photon)               // 1_trace_photon.c
DECLARE_CHECKS(estimate_radiance)          // 1_estimate_radiance.c
DECLARE_CHECKS(sample_lobe)                // 2_sample_lobe.c
DECLARE_CHECKS(turn_to)                    // 2_turn_to.c
DECLARE_CHECKS(scatter_glossy_source_text) // 2_scatter_glossy_source_text.c
DECLARE_CHECKS(scatter_glossy_phong)       // 2_scatter_glossy_phong.c
DECLARE_CHECKS(refract)                    // 3_refract.c
DECLARE_CHECKS(fresnel)                    // 3_fresnel.c
DECLARE_CHECKS(refractive_index)           // 3_refractive_index.c
DECLARE_CHECKS(trace_photon_in_colour)     // 3_trace_photon_in_colour.c
DECLARE_CHECKS(split_colour)               // 3_split_colour.c

// The picture of the step's stage, one array a set of thresholds (pictures.c).
void plan_picture_1(Plan *plan);
void judge_picture_1(const Results *results, Finding *finding);
void plan_picture_2_source(Plan *plan);
void judge_picture_2_source(const Results *results, Finding *finding);
void plan_picture_2_phong(Plan *plan);
void judge_picture_2_phong(const Results *results, Finding *finding);
void plan_picture_3(Plan *plan);
void judge_picture_3(const Results *results, Finding *finding);
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

#endif
