// The checks of all steps, in the order of step_table.
#include "judge/checks/step_checks.h"

#define STEP(stage, number, symbol, ...) {#stage "." #number, symbol##_checks, &symbol##_check_count},
const StepChecks step_checks[STEP_COUNT] = {
#include "steps/steps.def"
};
