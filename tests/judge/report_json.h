// report.json: everything that the judge found; the other reports are written from it (tests/judge/report/).
#ifndef PHOTONLAB_JUDGE_REPORT_JSON_H
#define PHOTONLAB_JUDGE_REPORT_JSON_H

#include "judge/report/report.h"
#include "judge/scatter/scatter.h"

// Writes report->directory/report.json and the pictures below it. The report holds directory, submission, sandbox, credit
// and seconds. `stages`: STAGE_COUNT of them; see print_results.
bool report_json_write(Report *report, const StepResult *results, int count, const StageResult *stages, Error *error);

#endif
