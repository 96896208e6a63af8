#include "judge/grade/grade.h"
#include "base/text.h"
#include "judge/checks/step_checks.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STEP(stage, number, symbol, ...) {#stage "." #number, symbol##_checks, &symbol##_check_count},
static const StepChecks step_checks[STEP_COUNT] = {
#include "steps/steps.def"
};

// Some check found what right code never does, whatever its random numbers.
static bool fails_for_certain(const StepResult *result)
{
    for (int i = 0; i < result->check_count; i++)
        if (result->checks[i].finding.failed && result->checks[i].check->kind != CHECK_PICTURE)
            return true;
    return false;
}

// A failure by chance alone is confirmed on fresh random numbers before it is one.
static bool needs_confirmation(const StepResult *result)
{
    bool chance = false;
    for (int i = 0; i < result->check_count; i++)
        chance = chance || (result->checks[i].status == STATUS_FAIL && !result->checks[i].finding.failed);
    return chance && !fails_for_certain(result);
}

static Status confirm(const GradeOptions *options, const StepChecks *checks, StepResult *result)
{
    StepResult *again = must(calloc(1, sizeof *again));
    again->step = result->step;
    again->check_count = result->check_count;
    again->words = result->words;
    Status status = run_checks(options, checks, false, 1, again);
    if (status == STATUS_PASS)
        status = run_checks(options, checks, true, 1, again);
    for (int i = 0; status == STATUS_PASS && i < *checks->count; i++) {
        CheckResult *first = &result->checks[i];
        if (first->status == STATUS_FAIL && !first->finding.failed && again->checks[i].status == STATUS_PASS)
            first->status = STATUS_PASS;
    }
    if (status != STATUS_PASS)
        result->words = again->words;
    step_result_free(again);
    free(again);
    return status;
}

// The first failure's words stand for the step: checks go from what is simple to what is not.
static void take_first_failure(StepResult *result)
{
    for (int i = 0; i < result->check_count; i++)
        if (result->checks[i].status == STATUS_FAIL) {
            const Finding *finding = &result->checks[i].finding;
            result->status =
                words_say(&result->words, STATUS_FAIL, "%s", finding->failed ? finding->message : finding->p_message);
            return;
        }
}

// For `make debug`: one line, the file of cases and the number of the one that failed.
static void write_failing(const GradeOptions *options, const StepResult *result)
{
    char directory[4000], path[4096];
    step_directory(options, result->step, directory, sizeof directory);
    snprintf(path, sizeof path, "%s/failing", directory);
    FILE *stream = fopen(path, "w");
    if (!stream)
        return; // only a convenience
    if (result->failing_cases && (result->status == STATUS_FAIL || result->status == STATUS_ERROR))
        fprintf(stream, "%s %ld %s\n", result->failing_cases, result->failing_case, status_table[result->status].name);
    fclose(stream);
}

// What a crash or an endless loop of this step comes from more often than not.
static void add_advice(StepResult *result)
{
    static const char path_ends[] = "Where photon_fly answers false, the path ends";
    static const struct {
        const char *step, *said, *advice;
    } known[] = {
        {"1.5", "did not end", path_ends},
        {"3.4", "did not end", path_ends},
        {"6.4", "did not end", path_ends},
        {"3.4", "stack", path_ends},
        {"3.4", "segmentation fault", "Of children only as many are there as split_colour answers"},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (strcmp(result->step->id, known[i].step) == 0 && strstr(result->words.message, known[i].said)) {
            text_append(result->words.message, sizeof result->words.message, " (%s.)", known[i].advice);
            return;
        }
}

void grade_step(const GradeOptions *options, const StepInfo *step, StepResult *result)
{
    double start = clock_seconds();
    *result = (StepResult){.step = step};
    const StepChecks *checks = &step_checks[step - step_table];
    result->check_count = *checks->count;
    for (int i = 0; i < *checks->count; i++)
        result->checks[i] = (CheckResult){.check = &checks->checks[i], .status = STATUS_SKIP, .finding = {.p = 1.0}};
    result->status = *checks->count > 0 ? compile_step(options, step, &result->words) : STATUS_SKIP;
    result->playable = result->status == STATUS_PASS;
    if (options->compile_only)
        return;
    if (result->status == STATUS_PASS)
        result->status = run_checks(options, checks, false, 0, result);
    if (result->status == STATUS_PASS)
        result->status = run_checks(options, checks, true, 0, result);
    char crash[sizeof result->words.message] = "";
    if (result->status == STATUS_ERROR) {
        add_advice(result);
        snprintf(crash, sizeof crash, "%s", result->words.message);
    }
    if (*crash && fails_for_certain(result))
        result->status = STATUS_PASS; // a wrong value comes before the crash that it led to
    if (result->status == STATUS_PASS && !options->first_round_only && needs_confirmation(result))
        result->status = confirm(options, checks, result);
    if (result->status == STATUS_PASS)
        take_first_failure(result);
    if (result->status == STATUS_FAIL && *crash)
        text_append(result->words.message, sizeof result->words.message, ". Later on %s", crash);
    if (result->status == STATUS_FAIL)
        diagnose(options, result);
    if (result->status == STATUS_FAIL || result->status == STATUS_ERROR)
        show_printed(options, result);
    write_failing(options, result);
    result->seconds = clock_seconds() - start;
}

void step_result_free(StepResult *result)
{
    for (int i = 0; i < result->check_count; i++) {
        image_free(&result->checks[i].finding.yours);
        image_free(&result->checks[i].finding.reference);
    }
}
