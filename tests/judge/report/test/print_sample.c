// Prints made-up results, for report.sh to read. Usage: print_sample [verbose]
#include "judge/judge.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const Check values = {.name = "values", .title = "A table of values", .kind = CHECK_VALUES};
static const Check density = {.name = "density", .title = "Directions follow the density", .kind = CHECK_SAMPLES};

static void set(StepResult *result, Status status, const char *message, const char *output)
{
    result->status = status;
    result->points = status == STATUS_PASS ? result->points_max : 0.0;
    snprintf(result->words.message, sizeof result->words.message, "%s", message);
    snprintf(result->words.output, sizeof result->words.output, "%s", output);
    for (int i = 0; i < result->check_count; i++)
        result->checks[i].status = status;
}

#define STEPS 15 // of the table's, so that a stage more changes nothing here

int main(int count, char **words)
{
    (void)words;
    StepResult *results = calloc(STEPS, sizeof *results);
    if (!results)
        return 1;
    char many[2000] = "";
    for (int i = 1; i <= 40; i++)
        snprintf(many + strlen(many), sizeof many - strlen(many), "line %d\n", i);
    for (int i = 0; i < STEPS; i++) {
        results[i] = (StepResult){.step = &step_table[i], .check_count = 2, .points_max = i == 0 ? 2.5 : 6.0};
        results[i].checks[0] = (CheckResult){.check = &values, .finding = {.p = 1.0}};
        results[i].checks[1] = (CheckResult){.check = &density, .threshold = 3.3e-4, .finding = {.p = 0.3, .tests = 6}};
        set(&results[i], STATUS_PASS, "", "");
    }
    set(&results[6], STATUS_FAIL,
        "expected directions of density (n+1)/(2π)·cosⁿα; for n = 20 the mean of cosα should be 0.9545, found 0.9524",
        many);
    snprintf(results[6].looks_like, sizeof results[6].looks_like, "the exponent n in place of n+1");
    set(&results[7], STATUS_ERROR, "it does not compile",
        "exercises/2_glossy_lobe/2.2_turn_to.c:14:31: error: expected ‘;’\n   14 |     return x\n      |             ^\n");
    for (int i = 0; i < 2; i++)
        results[7].checks[i].status = STATUS_SKIP;
    set(&results[8], STATUS_FAIL, "secret words", "");
    results[8].hidden = true;
    set(&results[10], STATUS_ERROR, "crashed: segmentation fault", "\033]0;owned\007 \033[2J bytes \xff\xc0 end");
    snprintf(results[10].words.where, sizeof results[10].words.where, "refract, line 9");
    set(&results[13], STATUS_TODO, "not started", "");
    set(&results[14], STATUS_SKIP, "no debugger", "");
    StageResult stages[STAGE_COUNT] = {
        {.stage = 1, .status = STATUS_PASS, .steps = "1.1 1.3", .p = 0.2, .threshold = 2e-6, .tests = 500},
        {.stage = 2,
         .status = STATUS_FAIL,
         .steps = "2.1",
         .message = "the copper ball gets 31 % fewer photons than right (z = 14)"},
        {.stage = 3, .status = STATUS_TODO}};
    print_results(results, STEPS, stages, count > 1);
    free(results);
    return 0;
}
