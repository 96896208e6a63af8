#include "judge/grade/step_features.h"

void features_print(FILE *stream, const StepResult *results, int count)
{
    for (int i = 0; i < count; i++) {
        if (results[i].status == STATUS_TODO)
            continue;
        fprintf(stream, "%s %s", results[i].step->id, status_table[results[i].status].name);
        for (int c = 0; c < results[i].check_count; c++) {
            const CheckResult *check = &results[i].checks[c];
            for (int f = 0; f < check->finding.feature_count; f++)
                fprintf(stream, " %s:%.6g:%.3g", check->check->name, check->finding.features[f].value,
                        check->finding.features[f].error);
        }
        fprintf(stream, "\n");
    }
}
