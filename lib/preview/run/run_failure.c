// From the first sign that a run failed to the sentence for the student.
#include "preview/run/run_internal.h"
#include "preview/record/fault.h"
#include "base/parallel.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

#define MOST_PLACES     16
#define LONGEST_LOOK_UP 1.0 // s

// What the dying process wrote down.
static Fault fault_of(const Run *run)
{
    const WireCrash *crash = &run->crash;
    const unsigned long long most = (unsigned long long)WORKER_MEMORY_GB << 20;
    bool refused = crash->at.reason == ENOMEM; // the last that failed was to get memory
    // Filling much memory takes time: patience may end before the memory does. A picture has photons of its own.
    bool grown = run->request.kind != RUN_RENDER && crash->grown_kb > (run->stuck ? most / 4 : most / 8 * 7);
    Fault fault = {.kind = FAULT_SIGNAL,
                   .signal = crash->at.signal,
                   .address = crash->at.address,
                   .calls_itself = crash->inner.calls_itself,
                   .run = run->request.kind,
                   .patience = run->patience};
    if (crash->at.signal == 0)
        fault.kind = FAULT_EXIT;
    else if (crash->at.stack_far)
        fault.kind = FAULT_STACK;
    else if (refused || grown)
        fault.kind = FAULT_MEMORY;
    else if (run->stuck)
        fault.kind = FAULT_LOOP;
    else if (crash->at.signal == SIGABRT)
        fault.kind = FAULT_ABORT;
    if (run->stuck && !refused)
        fault.memory_gb = (double)crash->grown_kb / (1024.0 * 1024.0);
    if (!crash->inner.object[0])
        return fault;
    SourcePlace places[MOST_PLACES], *place = &fault.place;
    int count = crash_places(run->found, places, MOST_PLACES);
    fault_source_name(crash->inner.object, place->file, sizeof place->file);
    snprintf(place->function, sizeof place->function, "%s", crash->inner.symbol);
    for (int i = 0; i < count && place->line == 0; i++)
        if (strcmp(places[i].file, place->file) == 0)
            *place = places[i];
    return fault;
}

static void describe_end(const Run *run, char *text, size_t size)
{
    int status = run->end_status;
    if (run->stuck && run->still)
        snprintf(text, size, "a process of the run stands still and does not answer: was it stopped (kill -STOP)?");
    else if (run->stuck)
        fault_describe_what(&(Fault){.kind = FAULT_LOOP, .run = run->request.kind, .patience = run->patience}, text,
                            size);
    else if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL)
        snprintf(text, size,
                 "the run was ended from outside (signal 9): by hand, or by the system for want of memory?");
    else if (WIFSIGNALED(status))
        snprintf(text, size, "the run was ended by signal %d (%s)", WTERMSIG(status), strsignal(WTERMSIG(status)));
    else if (WEXITSTATUS(status) == 127)
        snprintf(text, size, "no process could be started: too many, or no memory left");
    else
        snprintf(text, size, "a step ended the program (exit code %d) before the run was done", WEXITSTATUS(status));
}

// What steps_load says of objects, said of sources, which is what students know.
static void describe_words(const Run *run, char *text, size_t size)
{
    const char *words = run->words;
    char id[8] = "";
    sscanf(words, "step %7[0-9.]:", id);
    const StepInfo *step = step_find(id);
    const char *missing = strstr(words, "undefined symbol: "), *no_name = strstr(words, ": no step has this name");
    char file[256], object[1024];
    if (step && missing) {
        fault_describe_missing(run->broker->code_source, step, missing + strlen("undefined symbol: "), text, size);
    } else if (step && strstr(words, " has no function `")) {
        fault_source_name(step->file, file, sizeof file);
        snprintf(text, size, "%s: there is no function `%s` in it; see the prototype in lib/steps/", file,
                 step->symbol);
    } else if (no_name) {
        snprintf(object, sizeof object, "%.*s", (int)(no_name - words), words);
        fault_source_name(object, file, sizeof file);
        snprintf(text, size, "%s%s", file, no_name);
    } else {
        snprintf(text, size, "%.500s", words);
    }
}

static bool look_up(Run *run)
{
    char offset[32], caller[32];
    snprintf(offset, sizeof offset, "0x%llx", run->crash.inner.offset);
    snprintf(caller, sizeof caller, "0x%llx", run->crash.inner.caller);
    const char *const arguments[] = {"addr2line", "-f", "-i", "-e", run->crash.inner.object, offset, caller, NULL};
    run->look_until = clock_seconds() + LONGEST_LOOK_UP;
    return run->crash.inner.object[0] && process_start(&run->looker, arguments, PRINTS_OUTPUT);
}

static void finish_failure(Run *run)
{
    RunStatus *status = &run->status;
    Fault fault = fault_of(run);
    process_kill(&run->looker);
    if (run->words[0])
        describe_words(run, status->failure, sizeof status->failure);
    else if (run->has_crash)
        fault_describe(&fault, status->failure, sizeof status->failure);
    else
        describe_end(run, status->failure, sizeof status->failure);
    status->state = RUN_FAILED;
    status->news = true;
}

void run_go_on_with_failure(Run *run)
{
    process_read(&run->looker, run->found, sizeof run->found, &run->found_size);
    if (run->looker.output < 0 || clock_seconds() > run->look_until)
        finish_failure(run);
}

static bool has_failed(Run *run, bool all_done)
{
    const char *words = "";
    for (const Part *part = run->parts; part < run->parts + run->part_count; part++)
        if (!part->done && part->pipe < 0 && (run->words[0] || run->has_crash || part->ended)) {
            run->end_status = part->status;
            run->stuck = run->stuck || (run->has_crash && run->crash.at.signal == SIGUSR1);
            return true;
        }
    if (run->out_of_memory)
        words = "not enough memory for what the run found; use fewer photons";
    else if (!run->stuck && !all_done && (run->broker->socket < 0 || run->helper != run->broker->helpers))
        words = "the preview's helper process was ended, or did not answer";
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
