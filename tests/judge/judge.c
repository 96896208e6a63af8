// judge: grades a submission. It never loads a student's code: build/probe runs that, in a sandbox, and the judge
// looks at the numbers that come out.
#include "judge/judge.h"
#include "judge/checks/pictures.h"
#include "judge/grade/points.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <time.h>

#define USUAL_SECONDS 0.0012 // of the fixed task below, on the machine where the limits were chosen
#define MOST_SLOWNESS 4.0

static const char *absolute(const char *path, char whole[PATH_MAX])
{
    return realpath(path, whole) ? whole : path;
}

// Time limits grow with the machine's slowness, not with its load: processor time, the fastest of five.
static double machine_speed(void)
{
    double fastest = 1e9;
    for (int run = 0; run < 5; run++) {
        clock_t start = clock();
        Rng rng = rng_create(1, 1);
        volatile float sum = 0.0f;
        for (long i = 0; i < 200000; i++)
            sum = sum + rng_float(&rng);
        fastest = fmin(fastest, (double)(clock() - start) / CLOCKS_PER_SEC);
    }
    double factor = fastest / USUAL_SECONDS;
    return fmin(fmax(factor, 1.0), MOST_SLOWNESS);
}

// Found out before anybody is graded: what right code's pictures are like.
static bool references_are_there(Error *error)
{
    for (int i = 0; i < PICTURE_SETS; i++) {
        PictureReference reference;
        if (!picture_reference_read(&picture_sets[i], judge_root, &reference, error))
            return false;
    }
    return true;
}

// Measurements are of all stages, whatever the course has.
static bool is_wanted(const Arguments *a, const PointsTable *points, const StepInfo *step)
{
    bool of_course = step->stage <= points->stages || a->features || a->scatters > 0;
    return of_course && (!a->step || strcmp(a->step, step->id) == 0) && (a->stage == 0 || a->stage == step->stage);
}

static int exit_code(const Arguments *a, const StepResult *results, int count, const StageResult *stages)
{
    bool all = true, none_fails = true;
    for (int i = 0; i < count; i++) {
        if (results[i].status == STATUS_SKIP)
            return EXIT_UNGRADED;
        all = all && results[i].status == STATUS_PASS;
        none_fails = none_fails && (results[i].status == STATUS_PASS || results[i].status == STATUS_TODO);
    }
    for (int i = 0; i < STAGE_COUNT; i++) {
        if (stages[i].stage > 0 && stages[i].status == STATUS_SKIP)
            return EXIT_UNGRADED;
        none_fails = none_fails && stages[i].status != STATUS_FAIL && stages[i].status != STATUS_ERROR;
    }
    all = all && none_fails;
    return (a->strict ? all : none_fails) ? 0 : EXIT_FAILS;
}

// With no points yet, for a report that is cut short. How many.
static int list_wanted(const Arguments *a, const PointsTable *points, StepResult *results)
{
    int count = 0;
    for (size_t i = 0; i < STEP_COUNT; i++) {
        if (!is_wanted(a, points, &step_table[i]))
            continue;
        results[count] = (StepResult){.step = &step_table[i], .status = STATUS_SKIP};
        snprintf(results[count].words.message, sizeof results[count].words.message, "grading did not get this far");
        points_give(points, &results[count++]);
    }
    return count;
}

// What grading took: the judge, and all compilers and probes that it ran.
static void print_cost(double seconds)
{
    double processor = 0.0;
    long largest = 0;
    const int whose[] = {RUSAGE_SELF, RUSAGE_CHILDREN};
    for (int i = 0; i < 2; i++) {
        struct rusage usage;
        getrusage(whose[i], &usage);
        processor += (double)usage.ru_utime.tv_sec + 1e-6 * (double)usage.ru_utime.tv_usec;
        processor += (double)usage.ru_stime.tv_sec + 1e-6 * (double)usage.ru_stime.tv_usec;
        largest = usage.ru_maxrss > largest ? usage.ru_maxrss : largest;
    }
#ifdef __APPLE__
    largest /= 1024; // bytes there, thousands of them elsewhere
#endif
    fprintf(stderr, "took %.2f s, %.2f s of processor time, %.0f MB in the largest process\n", seconds, processor,
            (double)largest / 1024.0);
}

static bool report(const Arguments *a, double seconds, const StepResult *results, int count, const StageResult *stages,
                   Error *error)
{
    Report head = {.directory = a->report,
                   .submission = a->grade.code,
                   .sandbox = sandbox_name(a->grade.sandbox),
                   .credit = a->grade.sandbox != SANDBOX_NONE,
                   .seconds = seconds};
    return !a->report || report_json_write(&head, results, count, stages, error);
}

static int fail(const Error *error, int code)
{
    fprintf(stderr, "judge: %s\n", error->message);
    return code;
}

static int run(Arguments *a, const PointsTable *points, StepResult *results)
{
    StageResult stages[STAGE_COUNT] = {{0}};
    double start = clock_seconds();
    Error error = {""};
    int count = list_wanted(a, points, results);
    if (count == 0) {
        fprintf(stderr, "judge: the course has no step or stage like that; it has");
        for (size_t i = 0; i < step_count_of(points->stages); i++)
            fprintf(stderr, " %s", step_table[i].id);
        fprintf(stderr, ", and stages 1 to %d\n", points->stages);
        return EXIT_USAGE;
    }
    if (a->scatters > 0)
        return stages_measure(a, results, count);
    if (!report(a, 0.0, results, count, stages, &error)) // zero points stand there until there is something better
        return fail(&error, EXIT_UNGRADED);
    a->jobs =
        parallel_threads(a->jobs) < count ? parallel_threads(a->jobs) : count; // idle ones would wait at full speed
#pragma omp parallel for schedule(dynamic, 1) num_threads(a->jobs)
    for (int i = 0; i < count; i++) {
        StepResult *graded = must(calloc(1, sizeof *graded)); // the zero stays in the report until the step is done
        grade_step(&a->grade, results[i].step, graded);
        points_give(points, graded);
#pragma omp critical(report)
        {
            results[i] = *graded;
            report(a, clock_seconds() - start, results, count, stages, &error);
        }
        free(graded);
    }
    stages_grade(a, results, count, stages);
    if (a->features)
        print_features(results, count);
    else if (a->lines)
        print_lines_of_steps(results, count);
    else
        print_results(results, count, stages, a->verbose);
    if (a->verbose && !a->features)
        print_cost(clock_seconds() - start);
    int code = exit_code(a, results, count, stages);
    if (!report(a, clock_seconds() - start, results, count, stages, &error))
        code = fail(&error, EXIT_UNGRADED);
    for (int i = 0; i < count; i++)
        if (results[i].status == STATUS_SKIP)
            fprintf(stderr, "judge: step %s: %s\n", results[i].step->id, results[i].words.message);
    for (int i = 0; i < STAGE_COUNT; i++)
        stage_result_free(&stages[i]);
    for (int i = 0; i < count; i++)
        step_result_free(&results[i]);
    return code;
}

const char *judge_root = ".";

int main(int count, char **arguments)
{
    static char root[PATH_MAX], build[PATH_MAX], work[PATH_MAX];
    Arguments a;
    int wrong = arguments_parse(count, arguments, &a);
    if (wrong)
        return wrong == HELP_SHOWN ? 0 : wrong;
    mkdir(a.grade.work, 0755);
    a.grade.root = absolute(a.grade.root, root);
    a.grade.build = absolute(a.grade.build, build);
    a.grade.work = absolute(a.grade.work, work);
    judge_root = a.grade.root;
    if (!choose_sandbox(&a))
        return EXIT_UNGRADED;
    a.grade.speed = machine_speed();
    PointsTable points;
    Error error = {""};
    if (!submission_look_over(a.grade.code, &error))
        return fail(&error, EXIT_USAGE);
    if (!references_are_there(&error))
        return fail(&error, EXIT_UNGRADED);
    if (!points_read(a.points, &points, &error))
        return fail(&error, EXIT_USAGE);
    StepResult *results = calloc(STEP_COUNT, sizeof *results);
    int code = results ? run(&a, &points, results) : EXIT_UNGRADED;
    free(results);
    for (int i = 0; a.grade.hidden[i]; i++)
        free(a.grade.hidden[i]);
    return code;
}
