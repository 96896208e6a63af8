// One round of a step's checks: their cases are planned, run together, and judged.
#include "judge/grade/grade.h"

#include <stdlib.h>

#define STEP_LEVEL 1e-3 // chance that a right step fails its statistical checks in the first round

// One round's random numbers belong to salt, step, check and round alone, so that a regrade gives the same verdict.
static uint64_t seed_of(const GradeOptions *options, const char *id, const Check *check, int round)
{
    uint64_t hash = hash_u64(hash_text(0, options->salt));
    hash = hash_u64(hash_text(hash, id));
    hash = hash_u64(hash_text(hash, check->name));
    return hash_u64(hash + (uint64_t)round);
}

// The cases of all checks that run together, and where each check's begin.
typedef struct {
    Plan plan;
    size_t first[MOST_CHECKS], of[MOST_CHECKS];
} Cases;

#define SCENE_STEP(stage, number, ...) #stage "." #number " "
static const char in_scenes_alone[] =
#include "steps/steps.def"
    ;

// Does this check run now? In scenes, as for pictures, all other steps are there; otherwise only `needs` of the step.
static bool runs(const GradeOptions *options, const StepChecks *checks, const Check *check, bool scene)
{
    bool in_scene = check->kind == CHECK_PICTURE || step_is_listed(in_scenes_alone, checks->id);
    return in_scene == scene && !(options->no_pictures && check->kind == CHECK_PICTURE);
}

static void plan_checks(const GradeOptions *options, const StepChecks *checks, bool scene, int round, Cases *cases)
{
    Plan *plan = &cases->plan;
    *plan = (Plan){.step = checks->id};
    for (int i = 0; i < *checks->count; i++) {
        const Check *check = &checks->checks[i];
        if (!runs(options, checks, check, scene))
            continue;
        plan->first = cases->first[i] = plan->count;
        plan->seed = seed_of(options, checks->id, check, round);
        check->plan(plan);
        cases->of[i] = plan->count - plan->first;
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

Status run_checks(const GradeOptions *options, const StepChecks *checks, bool scene, int round, StepResult *result)
{
    Cases cases;
    plan_checks(options, checks, scene, round, &cases);
    Numbers *numbers = calloc(cases.plan.count + 1, sizeof *numbers);
    float *storage = NULL;
    long crashed = -1;
    Status status = STATUS_PASS;
    if (cases.plan.count > 0)
        status = run_probe(options, scene, &cases.plan, numbers, &storage, &crashed, result);
    for (int i = 0; i < *checks->count; i++) {
        if (!runs(options, checks, &checks->checks[i], scene))
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
    plan_free(&cases.plan);
    return status;
}
