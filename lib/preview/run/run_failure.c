// From the first sign that a run failed to the sentence for the student.
#include "preview/run/run_internal.h"
#include "base/crash_words.h"
#include "base/file.h"
#include "base/parallel.h"
#include "base/text.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

#define MOST_PLACES     16
#define LONGEST_LOOK_UP 1.0 // s

// "…/1.3_scatter_diffuse.so" becomes "1.3_scatter_diffuse.c".
static void source_of(const char *object, char *file, size_t size)
{
    const char *slash = strrchr(object, '/');
    const char *name = slash ? slash + 1 : object;
    size_t length = strlen(name);
    length -= length > 3 && strcmp(name + length - 3, ".so") == 0 ? 3 : 0;
    snprintf(file, size, "%.*s.c", (int)(length < 200 ? length : 200), name);
}

// A place in a header is the library's, built into the step.
static void read_answer(const char *text, SourcePlace *place)
{
    SourcePlace places[MOST_PLACES];
    int count = crash_places(text, places, MOST_PLACES);
    for (int i = 0; i < count && place->line == 0; i++)
        if (strcmp(places[i].file, place->file) == 0)
            *place = places[i];
}

static void put_place(const SourcePlace *place, const char *what, char *text, size_t size)
{
    char line[32] = "";
    if (place->line > 0)
        snprintf(line, sizeof line, ":%d", place->line);
    if (!place->file[0])
        snprintf(text, size, "%s", what);
    else if (place->function[0])
        snprintf(text, size, "%s%s: %s: %s", place->file, line, place->function, what);
    else
        snprintf(text, size, "%s%s: %s", place->file, line, what);
}

static void describe_loop(const Run *run, char *what, size_t size)
{
    RunKind kind = run->request.kind;
    snprintf(what, size, "ran for %.3g s without finishing a %s; an endless loop?", run->patience,
             kind == RUN_PHOTONS     ? "photon"
             : kind == RUN_LOBE      ? "direction"
             : kind == RUN_ESTIMATES ? "batch of estimates"
             : kind == RUN_DISKS     ? "pass"
                                     : "part of the picture");
}

// Filling much memory takes time: patience may end before the memory does. A picture has photons of its own.
static bool is_out_of_memory(const Run *run)
{
    const WireCrash *crash = &run->crash;
    unsigned long long most = (unsigned long long)WORKER_MEMORY_GB << 20;
    bool growing = run->stuck && run->request.kind != RUN_RENDER && crash->grown_kb > most / 4;
    return crash->refused || growing || (run->request.kind != RUN_RENDER && crash->grown_kb > most / 8 * 7);
}

static void describe_crash(const Run *run, char *what, size_t size)
{
    const WireCrash *crash = &run->crash;
    if (crash->signal == 0)
        snprintf(what, size, "called exit, which ends the whole program");
    else if (crash->stack_far)
        crash_describe_stack(NULL, crash->calls_itself ? "it" : NULL, what, size);
    else if (is_out_of_memory(run) && run->stuck && !crash->refused)
        snprintf(what, size, "asked for ever more memory: %.1f GB when it was stopped",
                 (double)crash->grown_kb / (1024.0 * 1024.0));
    else if (is_out_of_memory(run))
        snprintf(what, size, "asked for more than %d GB of memory", WORKER_MEMORY_GB);
    else if (run->stuck)
        describe_loop(run, what, size);
    else if (crash->signal == SIGABRT)
        snprintf(what, size, "abort() was called (an assertion, or memory freed twice? The terminal may tell)");
    else
        crash_describe_signal(crash->signal, crash->address, "", what, size);
}

static void describe_end(const Run *run, char *text, size_t size)
{
    int status = run->end_status;
    if (run->stuck && run->still)
        snprintf(text, size, "a process of the run stands still and does not answer: was it stopped (kill -STOP)?");
    else if (run->stuck)
        describe_loop(run, text, size);
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

// The last line of the file that has this word: what is used is declared before. 0: none.
static int find_line(const char *folder, const StepInfo *step, const char *word)
{
    char path[4608];
    size_t size;
    snprintf(path, sizeof path, "%s/%s.c", folder, step->file);
    char *text = file_read(path, 1u << 20, &size, NULL);
    const char *last = NULL;
    for (const char *at = text; at && (at = text_find_word(at, word)); at++)
        last = at;
    int line = last ? text_line_of(text, last) : 0;
    free(text);
    return line;
}

static void describe_missing(const Run *run, const StepInfo *step, const char *symbol, char *text, size_t size)
{
    SourcePlace place = {"", "", 0};
    char name[128], what[256];
    snprintf(name, sizeof name, "%.*s", (int)strcspn(symbol, " \n'(,;"), symbol);
    source_of(step->file, place.file, sizeof place.file);
    snprintf(place.function, sizeof place.function, "%s", step->symbol);
    place.line = find_line(run->broker->code_source, step, name);
    snprintf(what, sizeof what, "calls `%s`, and there is no such function", name);
    put_place(&place, what, text, size);
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
        describe_missing(run, step, missing + strlen("undefined symbol: "), text, size);
    } else if (step && strstr(words, " has no function `")) {
        source_of(step->file, file, sizeof file);
        snprintf(text, size, "%s: there is no function `%s` in it; see the prototype in lib/steps/", file,
                 step->symbol);
    } else if (no_name) {
        snprintf(object, sizeof object, "%.*s", (int)(no_name - words), words);
        source_of(object, file, sizeof file);
        snprintf(text, size, "%s%s", file, no_name);
    } else {
        snprintf(text, size, "%.500s", words);
    }
}

static void describe_failure(const Run *run, char *text, size_t size)
{
    if (run->words[0]) {
        describe_words(run, text, size);
        return;
    }
    if (!run->has_crash) {
        describe_end(run, text, size);
        return;
    }
    SourcePlace place = {"", "", 0};
    char what[256];
    if (run->crash.object[0]) {
        source_of(run->crash.object, place.file, sizeof place.file);
        snprintf(place.function, sizeof place.function, "%s", run->crash.symbol);
        read_answer(run->found, &place);
    }
    describe_crash(run, what, sizeof what);
    put_place(&place, what, text, size);
    if (!place.file[0])
        snprintf(text, size,
                 "%s, while none of your steps ran: did one write where it must not, or make photons "
                 "without end?",
                 what);
}

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
    describe_failure(run, run->status.failure, sizeof run->status.failure);
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
