// report.json: everything that the judge found; the other reports are written from it (tests/judge/report/).
#ifndef PHOTONLAB_JUDGE_REPORT_JSON_H
#define PHOTONLAB_JUDGE_REPORT_JSON_H

#include "judge/scatter/scatter.h"

typedef struct {
    const char *submission, *sandbox;
    bool credit;
    double seconds;
} ReportHead;

// Writes directory/report.json and directory/pictures/*.pfm. `stages`: STAGE_COUNT of them; see print_results.
bool report_json_write(const char *directory, const ReportHead *head, const StepResult *results, int count,
                       const StageResult *stages, Error *error);

#endif
