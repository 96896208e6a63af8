// From the first sign that a run failed to the sentence for the student.
#include "preview/run/run_internal.h"
#include "base/parallel.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>

#define LONGEST_LOOK_UP 1.0 // s

static void finish_failure(Run *run)
{
    process_kill(&run->looker);
    failure_describe(&run->failure, run->found, run->status.failure, sizeof run->status.failure);
    run->status.state = RUN_FAILED;
    run->status.news = true;
}

static void begin_failure(Run *run)
{
    run_end_workers(run);
    run->failing = true;
    run->failure.patience = run->patience;
    run->failure.kind = run->request.kind;
    run->failure.code_source = run->broker->code_source;
    run->look_until = clock_seconds() + LONGEST_LOOK_UP;
    if (run->failure.words || !failure_look_up(&run->failure, &run->looker))
        finish_failure(run);
}

void run_go_on_with_failure(Run *run)
{
    process_read(&run->looker, run->found, sizeof run->found, &run->found_size);
    if (run->looker.output < 0 || clock_seconds() > run->look_until)
        finish_failure(run);
}

static void fail_with(Run *run, const char *words)
{
    snprintf(run->words, sizeof run->words, "%s", words);
    run->failure.words = run->words;
    begin_failure(run);
}

void run_look_for_failure(Run *run)
{
    bool all_done = true;
    for (int i = 0; i < run->part_count && !run->failing; i++) {
        Part *part = &run->parts[i];
        all_done = all_done && part->done;
        if (part->done || part->pipe >= 0)
            continue;
        if (run->failure.has_crash && run->failure.crash.signal == SIGUSR1)
            run->failure.stuck = true;
        run->failure.status = part->status;
        if (run->failure.words || run->failure.has_crash || part->ended)
            begin_failure(run);
    }
    if (run->failing)
        return;
    if (run->out_of_memory)
        fail_with(run, "not enough memory for what the run found; use fewer photons");
    else if (run->failure.stuck)
        begin_failure(run);
    else if (run->broker->socket < 0 && !all_done)
        fail_with(run, "the preview's helper process is gone; start the preview again");
}
