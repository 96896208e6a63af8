// What a probe gives back: whole cases of the sizes that were asked for, or a forgery, whatever the step in it wrote. The first
// byte says which step it was; the sandbox's run is played here.
#include "fuzz/fuzz.h"
#include "judge/grade/grade.h"

static const uint8_t *written;
static size_t written_size;

bool sandbox_run(SandboxKind kind, const SandboxRun *run, SandboxResult *result, Error *error)
{
    (void)kind, (void)error;
    *result = (SandboxResult){.exit_code = 0};
    return write(run->result_fd, written, written_size) == (ssize_t)written_size;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static ProbeRun run;
    char *const lines[] = {"call 1 2 3", "call 2 4 5", "picture box yes 2 1", "paths box 7 1", "scatter box 7 1"};
    enum { COUNT = sizeof lines / sizeof *lines };
    if (size < 1)
        return 0;
    written = data + 1;
    written_size = size - 1;
    GradeOptions options = {.build = "build", .root = ".", .speed = 1.0};
    Numbers numbers[COUNT] = {{NULL, 0}};
    ProbeJob job = {.cases = "calls.txt", .id = step_table[data[0] % STEP_COUNT].id};
    snprintf(job.directory, sizeof job.directory, "%s", fuzz_folder());
    Status status = probe_job_run(&options, &job, lines, COUNT, numbers, &run);
    require(run.whole <= COUNT && (status == STATUS_PASS) == (run.whole == COUNT && !run.forged));
    volatile float sum = 0.0f;
    for (size_t i = 0; i < run.whole; i++)
        for (size_t j = 0; j < numbers[i].count; j++)
            sum = sum + numbers[i].values[j];
    free(run.storage);
    return 0;
}
