// How often groups of pictures fail in the first round, by the judge's own functions.
#include "judge/checks/statistics.h"
#include "calibrate.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    const PictureSet *set;
    double *T, *V;
    long failed_T, failed_V, failed;
    char message[600];
} Measure;

static void measure_group(long group, const Results *pictures, void *data)
{
    Measure *m = data;
    Finding finding = {.p = 1.0, .failing_case = -1};
    picture_set_judge(m->set, m->set->V_counts, pictures, &finding);
    bool wrong = finding.failed || finding.p < 1.0;
    bool T = finding.failed || finding.T > finding.T_threshold;
    m->T[group] = finding.failed ? INFINITY : finding.T;
    m->V[group] = finding.V;
#pragma omp critical(calibrate_measure)
    {
        m->failed += wrong;
        m->failed_T += T;
        m->failed_V += !finding.failed && finding.V > finding.V_threshold;
        if (wrong && !m->message[0])
            memcpy(m->message, finding.failed ? finding.message : finding.p_message, sizeof m->message);
    }
    image_free(&finding.yours);
    image_free(&finding.reference);
}

static void print_share(const char *what, long hits, long trials)
{
    printf("  %s %ld/%ld = %.2f %% (95 %%: %.2f … %.2f)", what, hits, trials, 100.0 * (double)hits / (double)trials,
           100.0 * clopper_pearson_lower(hits, trials, 0.975), 100.0 * clopper_pearson_upper(hits, trials, 0.975));
}

bool measure_set(const Arguments *a, const PictureSet *set)
{
    Measure m = {.set = set,
                 .T = must(calloc((size_t)a->measure, sizeof(double))),
                 .V = must(calloc((size_t)a->measure, sizeof(double)))};
    bool ok = groups_run(a, set, PURPOSE_MEASURE, a->measure, measure_group, &m);
    if (ok) {
        sort_values(m.T, a->measure);
        sort_values(m.V, a->measure);
        printf("%-8s %-28s", set->name, a->name ? a->name : a->object ? a->object : "right code");
        print_share("fail", m.failed, a->measure);
        printf("  by T %ld, by V %ld  T %.1f … %.1f … %.1f  V median %.2f\n", m.failed_T, m.failed_V, m.T[0],
               m.T[a->measure / 2], m.T[a->measure - 1], m.V[a->measure / 2]);
        if (m.message[0])
            printf("         \"%s\"\n", m.message);
        fflush(stdout);
    }
    free(m.T);
    free(m.V);
    return ok;
}
