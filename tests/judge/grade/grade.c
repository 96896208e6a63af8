#include "judge/grade/grade.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STEP_LEVEL 1e-3 // chance that a right step fails its statistical checks in the first round

static uint64_t hash_text(uint64_t hash, const char *text)
{
    for (; *text; text++)
        hash = hash_u64(hash ^ (uint64_t)(unsigned char)*text);
    return hash_u64(hash);
}

// One round's random numbers belong to salt, step, check and round alone, so that a regrade gives the same verdict.
static uint64_t seed_of(const GradeOptions *options, const char *id, const Check *check, int round)
{
    uint64_t hash = hash_text(0, options->salt);
    hash = hash_text(hash, id);
    hash = hash_text(hash, check->name);
    return hash_u64(hash + (uint64_t)round);
}

// The cases of all checks that run together, and where each check's begin.
typedef struct {
    char **lines;
    size_t count, first[MOST_CHECKS], of[MOST_CHECKS];
} Cases;

static void cases_free(Cases *cases)
{
    for (size_t i = 0; i < cases->count; i++)
        free(cases->lines[i]);
    free(cases->lines);
}

// Does this check run now?
static bool runs(const GradeOptions *options, const Check *check, bool scene)
{
    return check->scene == scene && !(options->no_pictures && check->kind == CHECK_PICTURE);
}

static void plan_checks(const GradeOptions *options, const StepChecks *checks, bool scene, int round, Cases *cases)
{
    *cases = (Cases){NULL, 0, {0}, {0}};
    for (int i = 0; i < *checks->count; i++) {
        const Check *check = &checks->checks[i];
        if (!runs(options, check, scene))
            continue;
        Plan plan = {.seed = seed_of(options, checks->id, check, round), .step = checks->id};
        check->plan(&plan);
        cases->lines = must(realloc(cases->lines, (cases->count + plan.count + 1) * sizeof *cases->lines));
        if (plan.count > 0)
            memcpy(cases->lines + cases->count, plan.lines, plan.count * sizeof *plan.lines);
        free(plan.lines);
        cases->first[i] = cases->count;
        cases->of[i] = plan.count;
        cases->count += plan.count;
    }
}

static int statistical_checks(const StepChecks *checks)
{
    int count = 0;
    for (int i = 0; i < *checks->count; i++)
        count += checks->checks[i].kind == CHECK_SAMPLES || checks->checks[i].kind == CHECK_ENERGY;
    return count > 0 ? count : 1;
}

static double threshold_of(const StepChecks *checks, const Check *check, const Finding *finding)
{
    double level =
        check->kind == CHECK_PICTURE ? 1e-9 : STEP_LEVEL / statistical_checks(checks); // a picture's p is 0 or 1
    return level / (finding->tests > 0 ? finding->tests : 1);
}

static void judge_check(const StepChecks *checks, int i, Results results, CheckResult *result)
{
    const Check *check = &checks->checks[i];
    image_free(&result->finding.yours);
    image_free(&result->finding.reference);
    *result = (CheckResult){.check = check, .finding = {.p = 1.0, .failing_case = -1}};
    check->judge(&results, &result->finding);
    result->threshold = threshold_of(checks, check, &result->finding);
    result->status = result->finding.failed || result->finding.p < result->threshold ? STATUS_FAIL : STATUS_PASS;
}

// Remembers the first case that went wrong.
static void note_failing(StepResult *result, bool scene, long number)
{
    if (result->failing_cases || number < 0)
        return;
    result->failing_cases = scene ? "scenes.txt" : "calls.txt";
    result->failing_case = number;
}

// Runs and judges the checks of one kind (called alone or in scenes). STATUS_ERROR: the code did not get through.
static Status run_checks(const GradeOptions *options, const StepChecks *checks, bool scene, int round,
                         StepResult *result)
{
    Cases cases;
    plan_checks(options, checks, scene, round, &cases);
    Numbers *numbers = calloc(cases.count + 1, sizeof *numbers);
    float *storage = NULL;
    long crashed = -1;
    Status status = STATUS_PASS;
    if (cases.count > 0)
        status = run_probe(options, result->step, scene, cases.lines, cases.count, numbers, &storage, &crashed, result);
    for (int i = 0; i < *checks->count; i++) {
        if (!runs(options, &checks->checks[i], scene))
            continue;
        CheckResult *check = &result->checks[i];
        bool complete = status == STATUS_PASS || (long)(cases.first[i] + cases.of[i]) <= crashed;
        if (complete) {
            uint64_t seed = seed_of(options, checks->id, &checks->checks[i], round);
            judge_check(checks, i, (Results){numbers + cases.first[i], cases.of[i], seed}, check);
            if (check->status == STATUS_FAIL && check->finding.failing_case >= 0)
                note_failing(result, scene, (long)cases.first[i] + check->finding.failing_case);
        } else {
            bool reached = (long)cases.first[i] <= crashed;
            *check =
                (CheckResult){.check = &checks->checks[i],
                              .status = reached ? STATUS_ERROR : STATUS_SKIP,
                              .finding = {.p = 1.0, .failing_case = reached ? crashed - (long)cases.first[i] : -1}};
        }
    }
    if (status == STATUS_ERROR)
        note_failing(result, scene, crashed);
    free(numbers);
    free(storage);
    cases_free(&cases);
    return status;
}

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
    if (fails_for_certain(result))
        return false;
    for (int i = 0; i < result->check_count; i++)
        chance = chance || (result->checks[i].status == STATUS_FAIL && !result->checks[i].finding.failed);
    return chance;
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
    if (status != STATUS_PASS) {
        result->words = again->words;
    }
    step_result_free(again);
    free(again);
    return status;
}

// The first failure's words stand for the step: checks go from what is simple to what is not.
static void take_first_failure(StepResult *result)
{
    for (int i = 0; i < result->check_count; i++) {
        const CheckResult *check = &result->checks[i];
        if (check->status != STATUS_FAIL || result->status == STATUS_FAIL)
            continue;
        result->status = STATUS_FAIL;
        const Finding *finding = &check->finding;
        snprintf(result->words.message, sizeof result->words.message, "%s",
                 finding->failed ? finding->message : finding->p_message);
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
