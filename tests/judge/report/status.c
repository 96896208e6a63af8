#include "judge/report/status.h"

#include <stddef.h>

const StatusInfo status_table[STATUSES] = {
    [STATUS_PASS] = {"pass", "✓", "passed", "passed"},
    [STATUS_FAIL] = {"fail", "✗", "failed", "failed"},
    [STATUS_ERROR] = {"error", "!", "with an error", "errors"},
    [STATUS_TODO] = {"todo", "○", "not started", "not_started"},
    [STATUS_SKIP] = {"skip", "–", "not checked", NULL},
};

bool status_is_wrong(Status status)
{
    return status == STATUS_FAIL || status == STATUS_ERROR;
}
