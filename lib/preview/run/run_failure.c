// From the first sign that a run failed to the sentence for the student.
#include "preview/run/run_internal.h"
#include "base/parallel.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>

#define LONGEST_LOOK_UP 1.0 // s

static bool look_up(Run *run)
{
    char offset[32];
    snprintf(offset, sizeof offset, "0x%llx", run->crash.offset);
    const char *const arguments[] = {"addr2line", "-f", "-i", "-e", run->crash.object, offset, NULL};
    run->look_until = clock_seconds() + LONGEST_LOOK_UP;
    return run->crash.object[0] && process_start(&run->looker, arguments, PRINTS_OUTPUT);
}

static void finish_failure(Run *run)
{
    process_kill(&run->looker);
    run_describe_failure(run, run->status.failure, sizeof run->status.failure);
    run->status.state = RUN_FAILED;
    run->status.news = true;
}

void run_go_on_with_failure(Run *run)
{
    process_read(&run->looker, run->found, sizeof run->found, &run->found_size);
    if (run->looker.output < 0 || clock_seconds() > run->look_until)
        finish_failure(run);
}

static const Part *failed_part(const Run *run)
{
    for (const Part *part = run->parts; part < run->parts + run->part_count; part++)
        if (!part->done && part->pipe < 0 && (run->words[0] || run->has_crash || part->ended))
            return part;
    return NULL;
}

static bool has_failed(Run *run, bool all_done)
{
    const Part *part = failed_part(run);
    const char *words = "";
    if (part) {
        run->end_status = part->status;
        run->stuck = run->stuck || (run->has_crash && run->crash.signal == SIGUSR1);
        return true;
    }
    if (run->out_of_memory)
        words = "not enough memory for what the run found; use fewer photons";
    else if (!run->stuck && run->broker->socket < 0 && !all_done)
        words = "the preview's helper process is gone; start the preview again";
    if (words[0])
        snprintf(run->words, sizeof run->words, "%s", words);
    return words[0] || run->stuck;
}

bool run_look_for_failure(Run *run, bool all_done)
{
    if (!has_failed(run, all_done))
        return false;
    run_end_workers(run);
    run->failing = true;
    if (run->words[0] || !look_up(run))
        finish_failure(run);
    return true;
}
