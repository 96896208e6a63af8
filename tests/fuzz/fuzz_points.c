// The table of points: numbers that add up, or a message with its line.
#include "fuzz/fuzz.h"
#include "judge/grade/points.h"

#include <math.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const char *path = fuzz_file("points.txt", data, size);
    PointsTable table;
    Error error = {""};
    bool fine = points_read(path, &table, &error);
    require(fine ? !error.message[0] : strncmp(error.message, path, strlen(path)) == 0);
    for (size_t i = 0; fine && i < STEP_COUNT; i++) {
        StepResult result = {.step = &step_table[i], .status = STATUS_PASS};
        points_give(&table, &result);
        require(isfinite(result.points) && result.points >= 0.0 && result.points <= result.points_max);
    }
    return 0;
}
