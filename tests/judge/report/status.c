#include "judge/report/status.h"

#include <stddef.h>

const StatusInfo status_table[STATUSES] = {
    [STATUS_PASS] = {"pass", "✓", "passed"},          [STATUS_FAIL] = {"fail", "✗", "failed"},
    [STATUS_ERROR] = {"error", "!", "with an error"}, [STATUS_TODO] = {"todo", "○", "not started"},
    [STATUS_SKIP] = {"skip", "–", "not checked"},
};

bool status_is_wrong(Status status)
{
    return status == STATUS_FAIL || status == STATUS_ERROR;
}
