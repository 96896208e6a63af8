#include "judge/judge.h"

#include <stdio.h>

void stages_grade(const Arguments *a, const StepResult *results, int count, StageResult *stages)
{
    if (a->step || a->features)
        return;
#pragma omp parallel for schedule(dynamic, 1) num_threads(parallel_threads(a->jobs)) if (a->stage == 0)
    for (int i = 0; i < STAGE_COUNT; i++) {
        if (a->stage != 0 && a->stage != i + 1)
            continue;
        grade_scatter(&a->grade, i + 1, results, count, &stages[i]);
        if (a->report)
            scatter_draw(&a->grade, a->report, &stages[i]);
    }
}

int stages_measure(const Arguments *a, StepResult *results, int count)
{
#pragma omp parallel for schedule(dynamic, 1) num_threads(parallel_threads(a->jobs))
    for (int i = 0; i < count; i++)
        grade_step(&a->grade, results[i].step, &results[i]);
#pragma omp parallel for schedule(dynamic, 1) num_threads(parallel_threads(a->jobs))
    for (int i = 0; i < STAGE_COUNT; i++) {
        for (int n = 0; n < a->scatters; n++) {
            char salt[200];
            GradeOptions options = a->grade;
            StageResult stage;
            snprintf(salt, sizeof salt, "%.150s %d", a->grade.salt, n);
            options.salt = salt;
            grade_scatter(&options, i + 1, results, count, &stage);
#pragma omp critical(measured)
            if (stage.status != STATUS_TODO)
                printf("%d %s %.3g %.3g %s\n", i + 1, status_table[stage.status].name, stage.p, stage.threshold,
                       stage.message);
            stage_result_free(&stage);
        }
    }
    return 0;
}
