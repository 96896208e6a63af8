// The checks of all steps, in the order of step_table (lib/steps/step_table.c).
#include "judge/checks/step_checks.h"

#define STEP(id, name, needs, twins)                                                                                   \
    {                                                                                                                  \
        id, needs, twins, name##_checks, &name##_check_count                                                           \
    }

// What a step may call while it is called alone, and what does the same work: check.h.
const StepChecks step_checks[STEP_COUNT] = {
    STEP("1.1", reflect, "", ""),
    STEP("1.2", emit_photon, "1.3", ""),
    STEP("1.3", scatter_diffuse, "", ""),
    STEP("1.4", russian_roulette, "", ""),
    STEP("1.5", trace_photon, "", "3.4 3.5"),
    STEP("1.6", estimate_radiance, "", ""),
    STEP("2.1", sample_lobe, "", ""),
    STEP("2.2", turn_to, "", ""),
    STEP("2.3", scatter_glossy_source_text, "1.1 1.3 2.1 2.2", "2.4"),
    STEP("2.4", scatter_glossy_phong, "1.1 2.1 2.2", "2.3"),
    STEP("3.1", refract, "", ""),
    STEP("3.2", fresnel, "", ""),
    STEP("3.3", refractive_index, "", ""),
    STEP("3.4", trace_photon_in_colour, "", "1.5"),
    STEP("3.5", split_colour, "", ""),
};
