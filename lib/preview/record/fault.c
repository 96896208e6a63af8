#include "preview/record/fault.h"
#include "base/file.h"
#include "base/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void fault_source_name(const char *path, char *file, size_t size)
{
    const char *slash = strrchr(path, '/');
    const char *name = slash ? slash + 1 : path;
    size_t length = strlen(name);
    length -= length > 3 && strcmp(name + length - 3, ".so") == 0 ? 3 : 0;
    snprintf(file, size, "%.*s.c", (int)(length < 200 ? length : 200), name);
}

static void put_place(const SourcePlace *place, const char *what, char *text, size_t size)
{
    snprintf(text, size, "%s", place->file);
    if (place->line > 0)
        text_append(text, size, ":%d", place->line);
    if (place->function[0])
        text_append(text, size, ": %s", place->function);
    text_append(text, size, ": %s", what);
}

void fault_describe_what(const Fault *fault, char *what, size_t size)
{
    static const char *const PARTS[] = {[RUN_PHOTONS] = "photon",
                                        [RUN_LOBE] = "direction",
                                        [RUN_ESTIMATES] = "batch of estimates",
                                        [RUN_DISKS] = "pass",
                                        [RUN_RENDER] = "part of the picture"};
    switch (fault->kind) {
    case FAULT_EXIT:
        snprintf(what, size, "called exit, which ends the whole program");
        return;
    case FAULT_STACK:
        crash_describe_stack(NULL, fault->calls_itself ? "it" : NULL, what, size);
        return;
    case FAULT_MEMORY:
        if (fault->memory_gb > 0.0)
            snprintf(what, size, "asked for ever more memory: %.1f GB when it was stopped", fault->memory_gb);
        else
            snprintf(what, size, "asked for more than %d GB of memory", WORKER_MEMORY_GB);
        return;
    case FAULT_LOOP:
        snprintf(what, size, "ran for %.3g s without finishing a %s; an endless loop?", fault->patience,
                 PARTS[fault->run]);
        return;
    case FAULT_ABORT:
        snprintf(what, size, "abort() was called (an assertion, or memory freed twice? The terminal may tell)");
        return;
    case FAULT_SIGNAL:
    case FAULT_KINDS:
        crash_describe_signal(fault->signal, fault->address, "", what, size);
    }
}

void fault_describe(const Fault *fault, char *text, size_t size)
{
    char what[256];
    fault_describe_what(fault, what, sizeof what);
    if (fault->place.file[0])
        put_place(&fault->place, what, text, size);
    else
        snprintf(text, size,
                 "%s, while none of your steps ran: did one write where it must not, or make photons without end?",
                 what);
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

void fault_describe_missing(const char *folder, const StepInfo *step, const char *symbol, char *text, size_t size)
{
    SourcePlace place = {"", "", 0};
    char name[128], what[256];
    snprintf(name, sizeof name, "%.*s", (int)strcspn(symbol, " \n'(,;"), symbol);
    fault_source_name(step->file, place.file, sizeof place.file);
    snprintf(place.function, sizeof place.function, "%s", step->symbol);
    place.line = find_line(folder, step, name);
    snprintf(what, sizeof what, "calls `%s`, and there is no such function", name);
    put_place(&place, what, text, size);
}

bool fault_describe_unplayed(const Recording *recording, const StepInfo *step, const char *make, char *text,
                             size_t size)
{
    if (recording->states[step - step_table] != STEP_STUDENT || step_is_played(step, recording->play))
        return false;
    snprintf(text, size, "%s is built, but another step plays in its place; %s FLAGS=\"--steps %s\" plays it", step->id,
             make, step_chosen_by(step)->id);
    return true;
}
